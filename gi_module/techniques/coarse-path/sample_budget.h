// How many samples each point gets of a frame's: more where light is uncertain or newly seen.
#pragma once

#include "gi_module/techniques/coarse-path/point_history.h"

namespace lanthorn::gi {

// Numbers of samples by point, `mean` a point on average: a quarter of them even, the others in proportion to
// the relative standard error of the points' tiles (8x8 of the lattice), and up to four times as many where
// fewer samples than `wanted` are known. Fractions are rounded up or down by a number fixed by pixel and
// `frame`; no point without samples gets none. O(points).
std::vector<int> share_samples(const GridPoints& points, std::span<const PointEstimate> known, float mean,
                               float wanted, std::uint32_t frame);

}  // namespace lanthorn::gi
