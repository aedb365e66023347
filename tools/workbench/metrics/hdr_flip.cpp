#include "lanthorn/workbench/hdr_flip.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::workbench {

namespace {

// The tone curve (a x^2 + b x) / (c x^2 + d x + e); the authors undo its built-in exposure of 0.6.
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;
constexpr double kTarget = 0.85;  // of white, at the first and last exposure

double tone_map(double x) {
    return std::clamp((x * (kA * x + kB)) / (x * (kC * x + kD) + kE), 0.0, 1.0);
}

// Where the curve reaches kTarget.
double target_input() {
    const double a = kA - kTarget * kC, b = kB - kTarget * kD, c = -kTarget * kE;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

ImageF exposed(const ImageF& image, double stops) {
    const double scale = std::exp2(stops);
    ImageF result = image;
    for (float& v : result.pixels) {
        v = static_cast<float>(tone_map(scale * std::max(static_cast<double>(v), 0.0)));
    }
    return result;
}

}  // namespace

Exposures flip_exposures(const ImageF& reference) {
    const auto channels = static_cast<std::size_t>(reference.channels);
    std::vector<double> luminances;
    for (std::size_t p = 0; p < reference.pixels.size(); p += channels) {
        const auto value = [&](std::size_t c) {
            return std::max(static_cast<double>(reference.pixels[p + c]), 0.0);
        };
        const double y = 0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2);
        if (y > 0) {
            luminances.push_back(y);
        }
    }
    if (luminances.empty()) {
        return {0, 0, 1};
    }
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = *middle;
    const double brightest = *std::max_element(middle, luminances.end());
    const double x = target_input();
    Exposures result{std::log2(x / brightest), std::log2(x / median), 0};
    result.count = std::max(2, static_cast<int>(std::ceil(result.stop - result.start)));
    return result;
}

std::vector<float> hdr_flip(const ImageF& image, const ImageF& reference, double pixels_per_degree) {
    const Exposures exposures = flip_exposures(reference);
    std::vector<float> largest;
    for (int i = 0; i < exposures.count; ++i) {
        const double stops = exposures.at(i);
        const std::vector<float> map =
            flip(exposed(image, stops), exposed(reference, stops), Encoding::linear, pixels_per_degree);
        largest.resize(map.size(), 0);
        std::ranges::transform(map, largest, largest.begin(),
                               [](float a, float b) { return std::max(a, b); });
    }
    return largest;
}

}  // namespace lanthorn::workbench
