// A program's table of actions, made up.
#pragma once

#include <cstdint>

#include "lanthorn/input/action.h"

namespace lanthorn::input {

inline constexpr std::uint32_t kJump = 1, kDuck = 2, kLouder = 4;

enum class Act { forward, back, jump, duck, louder, pause };
inline constexpr Action kActs[] = {
    {"forward", "run forward", "W", Kind::held},
    {"back", "run back", "S", Kind::held},
    {"jump", "jump", "E, Pad A", Kind::pressed, kJump},
    {"duck", "duck", "F, Pad X", Kind::pressed, kDuck},
    {"louder", "louder", "R, Wheel Up", Kind::pressed, kLouder},
    {"pause", "pause", "Escape, Pad Start", Kind::menu},
};

}  // namespace lanthorn::input
