#pragma once

#include <vector>

#include "lanthorn/workbench/metrics.h"

namespace lanthorn::workbench {

// Structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004, eq. 13; Gaussian window of 11 x 11 pixels
// and standard deviation 1.5, K1 = 0.01, K2 = 0.03), by pixel, mean of the channels: 1 for equal images, down
// to -1. `peak`: the range of values (L). Windows take in the pixels of `mask` alone (empty: all), weighted
// anew at borders; 0 where the mask is 0. Both images of equal size and channels. About 1 us a pixel and
// channel.
std::vector<float> ssim(const ImageF& image, const ImageF& reference, double peak, const PixelMask& mask);

}  // namespace lanthorn::workbench
