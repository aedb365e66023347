// Input for long tests.
#pragma once

#include <cstdint>
#include <random>

#include "game/rules/player_input.h"

namespace lanthorn::game {

// Somebody who walks and looks about and tries every button.
class Wanderer {
  public:
    explicit Wanderer(unsigned seed = 7) : random_(seed) {}
    PlayerInput next() {
        if (left_-- == 0) {
            left_ = whole(5, 50);
            input_.forward = axis(some(1) + 0.3);
            input_.right = axis(some(1));
            input_.yaw = input::turn_units(some(0.15));
            input_.pitch = input::turn_units(some(0.02));
            input_.held = static_cast<std::uint16_t>(whole(0, 511));
        }
        return input_;
    }

  private:
    // Of the same values with any C++ library.
    double some(double most) { return most * (2.0 * static_cast<double>(random_()) / 2147483647.0 - 1); }
    int whole(int least, int most) {
        return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
    }

    std::minstd_rand random_;
    int left_ = 0;
    PlayerInput input_;
};

}  // namespace lanthorn::game
