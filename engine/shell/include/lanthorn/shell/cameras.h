// Cameras that a person moves, or that follow something: to fly about in a level, to look at a thing from all
// sides, to walk behind a figure. Each gives a node's transform in the world; place_camera() puts an entity
// there. Metres, radians; +Y is up, and no camera rolls. Far from the origin they are as exact as near it.
#pragma once

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::shell {

// Where a camera looks: `yaw` counter-clockwise from -Z seen from above, `pitch` upwards.
struct Gaze {
    double yaw = 0, pitch = 0;

    // Adds to both. The pitch stops short of straight up and down, where a yaw would mean nothing; numbers
    // that are none count as 0.
    void turn(double more_yaw, double more_pitch);
    dvec3 ahead() const;  // unit
    // Over the ground, for who walks: `right` and `ahead` as this looks, at most 1 long.
    dvec3 walk(double right, double ahead) const;
    bool operator==(const Gaze&) const = default;
};

// A node at `place` that looks so.
dmat4 camera_at(const dvec3& place, const Gaze& gaze);
// The gaze of a node's transform; without its roll. One that looks nowhere (a zero scale) looks along -Z.
Gaze gaze_of(const dmat4& world);

// Flies where it is steered.
struct FlyCamera {
    dvec3 place{0};
    Gaze gaze = {};
    double speed = 3;  // m/s

    // Where a node's transform is and looks, without its roll.
    static FlyCamera from(const dmat4& world) { return {dvec3(world[3]), gaze_of(world)}; }
    // `way`: to the right, up (world), and ahead, -1..1 each; a longer way than 1 is flown at `speed` too.
    void move(const dvec3& way, double seconds);
    dmat4 world() const { return camera_at(place, gaze); }  // the node's transform
};

// Looks at one point from all sides.
struct OrbitCamera {
    dvec3 target{0};
    Gaze gaze = {};
    double distance = 5;

    static constexpr double kNearest = 1e-3, kFarthest = 1e7;  // metres

    // Nearer by a tenth a notch; farther where `notches` are below 0.
    void zoom(double notches);
    // Moves the target with the picture: `right` and `up` in heights of the picture, which has the vertical
    // opening angle `yfov`.
    void pan(double right, double up, double yfov);
    // All of `bounds` (relative to `origin`) in a picture of that opening angle and width / height. Empty or
    // non-finite bounds are taken as a cube of 2 m.
    void show_all(const Aabb& bounds, const dvec3& origin, double yfov, double aspect);
    dmat4 world() const { return camera_at(target - distance * gaze.ahead(), gaze); }  // the node's transform
};

// Follows what walks: behind it, above it, a little late.
struct FollowCamera {
    double distance = 3, height = 1.7;  // of its place, behind and above the target
    double pitch = -0.15;
    double half_life = 0.12;  // seconds in which half of the way to where it belongs is made; 0: it is there
    // Farther from where it belongs than so many distances it jumps: who it follows has been put elsewhere.
    static constexpr double kJump = 8;

    // To `target` that looks along `yaw`. However `seconds` are cut into frames, the way is the same for a
    // target that stands.
    void follow(const dvec3& target, double yaw, double seconds);
    dmat4 world() const;  // the node's transform, late as half_life says

  private:
    bool began_ = false;
    dvec3 target_{0};  // late
    double yaw_ = 0;   // likewise
};

// Gives the entity's LocalTransform what puts it at `world`, whatever its parents' transforms (of the newest
// frame) are; its scale is kept. Nothing where a parent has no extent.
void place_camera(ecs::World& in, ecs::Entity camera, const dmat4& world);

}  // namespace lanthorn::shell
