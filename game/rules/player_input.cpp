#include "game/rules/player_input.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::game {

std::int16_t axis(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767));
}

}  // namespace lanthorn::game
