// What the player has done is shown to her: when a crystal wakes, or a goal is reached, the picture looks at
// it for a while from a place where it is seen. Nothing of it reaches the simulation.
#pragma once

#include <optional>
#include <set>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/shown_scene.h"

namespace lanthorn::game {

class Reveal {
  public:
    static constexpr double kEase = 1.1;  // seconds until the picture has come there
    static constexpr double kHold = 1.9;  // that it stays, where there is more to do

    // Another level comes, or another state of it: what is awake in `world` is nothing new.
    void begin(const ecs::World& world);
    // Of a frame of play: what has woken since the last one is shown from now on, the last of several.
    void watch(const ecs::World& world);
    // Time passes. `stays`: it is the last of the level, and is looked at until release().
    void pass(double seconds, bool stays);
    void release() { target_.reset(); }

    bool showing() const { return target_.has_value(); }
    double seconds() const { return seconds_; }      // since it began to be shown
    const dvec3& place() const { return *target_; }  // of what is shown, in the world; while showing()
    int awake() const { return static_cast<int>(awake_.size()); }  // crystals and goals
    int all() const { return all_; }

    // The level's picture from there, in the next frame; while showing().
    void look(ShownScene& level);

  private:
    struct Way {
        dvec3 from{0}, to{0};      // of the camera
        dvec3 from_aim{0, 0, -1};  // unit, where it looked before
    };
    void start(const ecs::World& world, ecs::Entity target);

    std::set<ecs::Entity> awake_;
    int all_ = 0;
    std::optional<dvec3> target_;
    Way way_;
    double seconds_ = 0;
};

}  // namespace lanthorn::game
