// What is to be heard of a level: read off its entities from frame to frame. It alters nothing, so that a
// session is the same with sound and without.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "game/presentation/sound/effects.h"
#include "game/rules/components.h"
#include "lanthorn/audio/heard.h"
#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"

namespace lanthorn::game {

using audio::Ears;
using audio::Heard;
using audio::Sound;

class Ear {
  public:
    // Call after a frame. The first call after forget(), and one in which no step has passed since the last,
    // begins nothing.
    Heard listen(const ecs::World& world);
    // Another level comes, or another state of it.
    void forget() { *this = Ear(); }

    static constexpr double kStride = 0.72;  // metres from a step to the next

  private:
    template <class T>
    using Before = std::map<ecs::Entity, T>;

    void hear_steps(const ecs::World& world, Heard& heard);
    void hear_leaves(const ecs::World& world, Heard& heard);
    void hear_lanterns(const ecs::World& world, Heard& heard);
    void hear_crystals(const ecs::World& world, Heard& heard);

    bool began_ = false;
    std::uint64_t steps_ = 0;  // of the simulation, at the last call
    std::vector<Sound> going_;
    Before<dvec3> feet_;
    double walked_ = 0;  // metres since the last step
    bool left_ = false;  // which foot was last
    Before<Door> doors_;
    Before<Shutter> shutters_;
    Before<Pushed> pushed_;
    Before<Turntable> turntables_;
    Before<Lantern> lanterns_;
    Before<Crystal> crystals_;
    bool solved_ = false;
};

}  // namespace lanthorn::game
