// Candidate environment map centres U (Yao et al. 2010, sec. 4.1).
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// Points `first` .. `first + count - 1` of a fixed low-discrepancy sequence (R3, Roberts 2018) inside
// `bounds`, started at a place that `seed` decides. Empty or flat boxes are widened a little, so that points
// never coincide.
std::vector<vec3> candidate_points(const Aabb& bounds, int first, int count, std::uint32_t seed);

}  // namespace lanthorn::gi
