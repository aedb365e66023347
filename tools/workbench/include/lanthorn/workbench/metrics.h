// How far an image is from its reference: the measures of the project's error figures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/image.h"

namespace lanthorn::workbench {

// Which pixels count, by pixel: 0 or 1.
using PixelMask = std::vector<std::uint8_t>;

// 1 where any channel of `image` is not 0.
PixelMask lit_pixels(const ImageF& image);

// Over the valid pixels: those of the mask where either image is not exactly 0 in all channels (the
// background is exactly 0).
struct Difference {
    double relrmse = 0;  // root of the mean square over pixels and channels, divided by the reference's mean
    double rmse = 0;     // the same, not divided
    double mae = 0;      // mean absolute difference
    double max = 0;      // largest absolute difference
    double flux = 0;     // the image's mean divided by the reference's; 1: no bias
    double bias = 0;     // the means' difference divided by the reference's: flux - 1
    double mean = 0;
    double reference_mean = 0;
};

// How far one picture is from another.
struct Comparison {
    Difference all;  // all channels together
    std::vector<Difference>
        channels;  // each by itself; relrmse and flux are NaN where the reference is black
    std::size_t pixels = 0;
    std::size_t valid_pixels = 0;
    PixelMask valid;
    // The range of values that PSNR and SSIM are relative to: 1 where both images are within 0..1, else the
    // reference's largest value.
    double peak = 1;
    // 10 log10(peak^2 / mse) over all pixels of the mask. Infinite for equal images.
    double psnr = 0;
};

// `mask`: of the reference's size; empty: all pixels. Throws InputError, naming both files, if sizes or
// channel counts differ, a value is NaN or infinite (with its place), or the reference is black where the
// mask looks. O(pixels).
Comparison compare(const ImageF& image, const ImageF& reference, const std::string& image_name,
                   const std::string& reference_name, const PixelMask& mask = {});

// Mean of `values` over the pixels of `mask`, over all if it is empty.
double mean_over(const std::vector<float>& values, const PixelMask& mask);

// By pixel: mean absolute difference over the channels divided by the reference's mean.
std::vector<float> relative_error(const ImageF& image, const ImageF& reference, double reference_mean);

// `values` 0..1 as colours from black over purple and orange to white, display-encoded; beyond 1 is white.
ImageF heat_map(const std::vector<float>& values, int width, int height);

}  // namespace lanthorn::workbench
