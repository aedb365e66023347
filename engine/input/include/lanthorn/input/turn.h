// How far a view turns in a simulation step, as whole numbers: a recording holds exactly what was played.
#pragma once

#include <cstdint>

namespace lanthorn::input {

inline constexpr double kTurnUnit = 1.0 / 8192;  // radians

// Radians in kTurnUnit, rounded, at most 4 radians either way.
std::int16_t turn_units(double radians);

}  // namespace lanthorn::input
