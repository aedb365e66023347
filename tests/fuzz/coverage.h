// Which ways through the code an input takes: GCC's -fsanitize-coverage=trace-pc calls this program at every
// branch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lanthorn::fuzz {

// How often each pair of places followed each other, modulo the size of the map (Zalewski's AFL, 2014).
using CoverageMap = std::array<std::uint8_t, 1u << 16u>;

// Starts counting from 0.
void begin_coverage();

// Marks in `seen` what was counted since; returns whether any of it, in powers of two, is new.
bool add_coverage(CoverageMap& seen);

}  // namespace lanthorn::fuzz
