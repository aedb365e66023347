// The animation system: players move the entities of their scene.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/kept_query.h"
#include "lanthorn/ecs/lookup.h"

namespace lanthorn {

// One object a world; before Transforms::update. engine/runtime/animation_plugin.h has its systems.
class Animator {
  public:
    // What it reads and writes, as a system's parameters.
    using Players = ecs::Query<ecs::Write<AnimationPlayer>, ecs::Read<AnimationSet>>;
    using Poses = ecs::Lookup<ecs::Write<LocalTransform>, ecs::Write<MorphWeights>>;

    // Called for every value that show() overwrites, with the old and the new value.
    struct Overwritten {
        std::function<void(ecs::Entity, const Transform&, const Transform&)> transform;
        std::function<void(ecs::Entity, const std::vector<float>&, const std::vector<float>&)> weights;
    };

    // Moves every AnimationPlayer with an AnimationSet on by `seconds` (0 or more; anything else counts as 0)
    // and writes the LocalTransform and MorphWeights of the set's entities. Only what a clip of the player's
    // layers moves is written, and it counts as changed only where its value did. Entities that are gone or
    // have no such component are passed over.
    //
    // A pure function of the world and `seconds`. Cost: O(channels of the playing clips), each O(log keys) or
    // better. Allocates nothing once every player has seen its set and its layers their clips.
    // `clock`: seconds that players by the clock are at; those are not moved on.
    void animate(ecs::World& world, double seconds, double clock = 0);
    // The same as a system's: of the players that `players` finds, written through `poses`.
    void animate(const Players& players, const Poses& poses, double seconds, double clock);

    // The pose of a picture: of players by the clock at `clock`, of others as far back from where they are as
    // they came in the last `back` seconds (fades not considered). Nothing that animate() goes on from
    // changes but the poses. Players not by the clock are passed over if `back` is 0 and they were animated
    // before.
    void show(const Players& players, const Poses& poses, double back, double clock,
              const Overwritten& overwritten);

  private:
    ecs::KeptQuery<ecs::Write<AnimationPlayer>, ecs::Read<AnimationSet>> players_;
    std::vector<double> times_;  // of the layers of the player at hand

    void show(AnimationPlayer& player, const Poses& poses, double back, double clock,
              const Overwritten& overwritten);
};

// The same without an object; finds the players again each time.
void animate(ecs::World& world, double seconds);

}  // namespace lanthorn
