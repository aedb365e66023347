// The fixed step of the simulation: here and nowhere else.
#pragma once

#include <cstdint>

namespace lanthorn {

inline constexpr double kStepsPerSecond = 60;
inline constexpr double kStepSeconds = 1.0 / kStepsPerSecond;

// Every so many steps everything that is not in components starts afresh, in every run (runtime/time.h).
inline constexpr std::uint64_t kKeySteps = 1800;

}  // namespace lanthorn
