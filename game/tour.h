// A scripted walk: from the start to the door, through it once it is open, and a look around in the dark
// half. The same inputs in every run.
#pragma once

#include <cstdint>
#include <vector>

#include "game/simulation.h"

namespace lanthorn::game {

class Tour {
  public:
    // Without a door it looks around where it starts.
    explicit Tour(const Level& level);

    static constexpr std::uint64_t kSteps = 60 * 10;    // the whole of it
    static constexpr std::uint64_t kDoorStep = 60 * 3;  // when it opens the door

    // Input of step `step`, from where the player stands before it.
    PlayerInput next(const View& view, std::uint64_t step) const;

  private:
    struct Leg {
        std::uint64_t until = 0;  // steps
        dvec3 goal{0};            // where to stand
        dvec3 target{0};          // where to look
    };
    std::vector<Leg> legs_;
    bool has_door_ = false;
};

}  // namespace lanthorn::game
