// Where a picture's caustics are brightest, so that noise hardly moves it. Pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::workbench {

// The mean place, by light, of the brightest hundredth of all pixels, after a Gaussian blur with a standard
// deviation of a 64th of the picture's width. `lux`: by pixel; only pixels that have a place count. None
// without light. O(pixels).
std::optional<dvec3> brightest_place(std::span<const double> lux, std::span<const std::optional<vec3>> places,
                                     ivec2 size);

}  // namespace lanthorn::workbench
