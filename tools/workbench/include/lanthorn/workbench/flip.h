#pragma once

#include <vector>

#include "lanthorn/core/image.h"

namespace lanthorn::workbench {

inline constexpr double kFlipPixelsPerDegree = 67;

// How pictures hold Rec. 709 primaries: display-encoded (PNG) or linear (EXR, HDR).
enum class Encoding { srgb, linear };

// LDR-FLIP (Andersson et al. 2020): what a person sees who flips between two pictures, 0 (nothing) to 1, by
// pixel. Both: equal sizes, at least three channels (the first three count), of that encoding, clamped to
// 0..1 here. About 1 us a pixel.
std::vector<float> flip(const ImageF& image, const ImageF& reference, Encoding encoding = Encoding::srgb,
                        double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace lanthorn::workbench
