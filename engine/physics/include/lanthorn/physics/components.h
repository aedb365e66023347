// The components that Physics follows. Angles in radians, all else in SI units. Declared for extras,
// snapshots and hashes in declare_components.cpp, where their ranges stand.
#pragma once

#include <cstdint>
#include <optional>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::physics {

// The form that others meet. convex: the hull of the entity's meshes; mesh: their triangles, not for a
// dynamic body.
enum class BodyShape : std::uint8_t { box, sphere, capsule, convex, mesh };
// fixed: never moves. dynamic: Physics moves it. kinematic: the game moves it by its transform, and it pushes
// dynamic ones.
enum class BodyType : std::uint8_t { fixed, dynamic, kinematic };

// What others meet, in the node's own space: its scale in the world stretches it. Alone on an entity it
// stands where its WorldTransform is, like a fixed RigidBody. Sizes left out are those of the entity's
// meshes.
struct Collider {
    BodyShape shape = BodyShape::box;
    double friction = 0.5;         // a contact has the product of both
    double restitution = 0;        // likewise
    std::optional<dvec3> size;     // metres, whole edges, of a box
    std::optional<double> radius;  // metres, of a sphere or capsule
    std::optional<double> height;  // metres, of a capsule along Y, its caps included
    std::optional<dvec3> centre;   // metres; left out: the bounds' centre, the origin where a size is given

    bool operator==(const Collider&) const = default;
};

// A body: how it takes part, and its shape.
struct RigidBody {
    BodyType type = BodyType::fixed;
    double mass = 1;  // kilograms, of a dynamic one
    Collider collider;

    bool operator==(const RigidBody&) const = default;
};

// A place in the world as exact as one near the origin: the sum of both.
struct ExactPoint {
    dvec3 whole{0};  // metres, integers
    dvec3 rest{0};   // metres

    bool operator==(const ExactPoint&) const = default;
};

// Whether it is simulated: moving, or still but not yet for long enough, or put to sleep until something
// touches it.
enum class BodyRest : std::uint8_t { awake, drowsy, asleep };

// How a dynamic body moves. Added, removed and written by Physics; a game that writes `linear` or `angular`
// gives the body that speed and wakes it.
struct BodyMotion {
    dvec3 linear{0};   // m/s, of the centre of mass
    dvec3 angular{0};  // radians/s, world space

    // Physics' own: where the centre of mass is in the world, to the last bit, and since when it has been
    // still. It holds as long as the entity's LocalTransform is `local`; a rotation of 0 never does.
    ExactPoint position;
    glm::dquat rotation{0, 0, 0, 0};
    double still = 0;  // seconds
    BodyRest rest = BodyRest::awake;
    Transform local;

    bool operator==(const BodyMotion&) const = default;
};

// An upright capsule that walks: its origin is between the feet. Its node's scale does not stretch it.
struct Character {
    double radius = 0.3;        // metres
    double height = 1.8;        // metres, from the feet to the top; at least two radii
    double step_height = 0.35;  // metres that a foot lifts, and reaches down without falling
    double slope_limit = 0.87;  // radians from the level that can still be walked on
    double jump_speed = 4.5;    // m/s at take-off

    bool operator==(const Character&) const = default;
};

// Written by the game before a step; without it the character stands.
struct CharacterInput {
    dvec3 velocity{0};  // m/s over the ground, world space; its Y is not regarded
    bool jump = false;  // takes off if it stands on ground
};

// How a character is. Added and written by Physics.
struct CharacterState {
    double vertical_speed = 0;  // m/s, upwards
    bool on_ground = false;

    // Physics' own: where the feet are in the world. It holds as long as the entity's LocalTransform has the
    // translation `local`.
    ExactPoint feet;
    dvec3 local{0};

    bool operator==(const CharacterState&) const = default;
};

}  // namespace lanthorn::physics
