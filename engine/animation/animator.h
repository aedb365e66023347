// The animation system: players move the entities of their scene.
#pragma once

#include <memory>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/kept_query.h"

namespace lanthorn {

// One object a world. As a system, before Transforms::update:
//   schedule.add("animation", [a = Animator()](ecs::World& w) mutable { a.animate(w, kStep); });
class Animator {
  public:
    // Moves every AnimationPlayer with an AnimationSet on by `seconds` (0 or more; anything else counts as 0)
    // and writes the LocalTransform and MorphWeights of the set's entities. Only what a clip of the player's
    // layers moves is written, and it counts as changed only where its value did. Entities that are gone or
    // have no such component are passed over.
    //
    // A pure function of the world and `seconds`. Cost: O(channels of the playing clips), each O(log keys) or
    // better. Allocates nothing once every player has seen its set and its layers their clips.
    void animate(ecs::World& world, double seconds);

  private:
    ecs::KeptQuery<ecs::Write<AnimationPlayer>, ecs::Read<AnimationSet>> players_;
};

// The same without an object; finds the players anew each time.
void animate(ecs::World& world, double seconds);

}  // namespace lanthorn
