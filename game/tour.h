// A scripted session: the player takes the lantern from its table, opens the door, and carries the light into
// the dark half. The same inputs in every run.
#pragma once

#include <cstdint>
#include <vector>

#include "game/player_input.h"
#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

class Tour {
  public:
    // For the level's first door and first lantern, from where the player stands. Without a door she looks
    // around where she starts.
    explicit Tour(const ecs::World& world);

    static constexpr std::uint64_t kSteps = 60 * 14;       // the whole of it
    static constexpr std::uint64_t kLanternStep = 60 * 2;  // when she takes the lantern
    static constexpr std::uint64_t kDoorStep = 60 * 5;     // when she opens the door

    // Input of step `step`, from where the player stands before it.
    PlayerInput next(const ecs::World& world, std::uint64_t step) const;

  private:
    struct Leg {
        std::uint64_t until = 0;  // steps
        dvec3 goal{0};            // where to stand
        dvec3 target{0};          // where to look
    };
    std::vector<Leg> legs_;
    bool has_door_ = false;
    bool has_lantern_ = false;
};

}  // namespace lanthorn::game
