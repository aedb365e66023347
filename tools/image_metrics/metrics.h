// How far an image is from its reference: the measures of the project's error figures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/assets/image_io.h"

namespace lanthorn::image_metrics {

// Over the valid pixels: those where either image is not exactly 0 in all channels (the background is exactly
// 0).
struct Difference {
    double relrmse = 0;  // root of the mean square over pixels and channels, divided by the reference's mean
    double rmse = 0;     // the same, not divided
    double mae = 0;      // mean absolute difference
    double max = 0;      // largest absolute difference
    double flux = 0;     // the image's mean divided by the reference's; 1: no bias
    double mean = 0;
    double reference_mean = 0;
};

struct Comparison {
    Difference all;  // all channels together
    std::vector<Difference>
        channels;  // each by itself; relrmse and flux are NaN where the reference is black
    std::size_t pixels = 0;
    std::size_t valid_pixels = 0;
    // 10 log10(peak^2 / mse) over all pixels; peak is 1 where both images are within 0..1, else the
    // reference's largest value. Infinite for equal images.
    double psnr = 0;
};

// Throws InputError, naming both files, if sizes or channel counts differ, a value is NaN or infinite (with
// its place), or the reference is black. O(pixels).
Comparison compare(const ImageF& image, const ImageF& reference, const std::string& image_name,
                   const std::string& reference_name);

// By pixel: mean absolute difference over the channels divided by the reference's mean.
std::vector<float> relative_error(const ImageF& image, const ImageF& reference, double reference_mean);

// `values` 0..1 as colours from black over purple and orange to white, display-encoded; beyond 1 is white.
ImageF heat_map(const std::vector<float>& values, int width, int height);

}  // namespace lanthorn::image_metrics
