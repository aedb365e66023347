// A scripted session: the legs that the level's file has (LevelInfo::tour), else the player takes the lantern
// from its table, opens the door, and carries the light into the dark half. The same inputs in every run.
#pragma once

#include <cstdint>
#include <vector>

#include "game/rules/components.h"
#include "game/rules/player_input.h"
#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

class Tour {
  public:
    // Without legs in the file: for the level's first door and first lantern, from where the player stands;
    // without a door she looks around where she starts.
    explicit Tour(const ecs::World& world);

    static constexpr std::uint64_t kSteps = 60 * 14;       // the whole of one that is made up
    static constexpr std::uint64_t kLanternStep = 60 * 2;  // when she takes the lantern
    static constexpr std::uint64_t kDoorStep = 60 * 5;     // when she opens the door

    std::uint64_t steps() const { return legs_.back().until; }  // the whole of it

    // Input of step `step`, from where the player stands before it.
    PlayerInput next(const ecs::World& world, std::uint64_t step) const;

  private:
    struct Stage {
        std::uint64_t until = 0;  // steps
        dvec3 goal{0};            // where to stand
        dvec3 target{0};          // where to look
        std::uint16_t held = 0;   // Buttons, in its last step
        bool hold = false;        // all the while
    };
    void follow(const std::vector<Leg>& legs);
    void make_up(const ecs::World& world);

    std::vector<Stage> legs_;  // at least one
};

}  // namespace lanthorn::game
