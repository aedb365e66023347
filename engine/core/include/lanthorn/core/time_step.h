// The fixed step of the simulation: here and nowhere else.
#pragma once

namespace lanthorn {

inline constexpr double kStepsPerSecond = 60;
inline constexpr double kStepSeconds = 1.0 / kStepsPerSecond;

}  // namespace lanthorn
