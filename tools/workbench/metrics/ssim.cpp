#include "lanthorn/workbench/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanthorn::workbench {

namespace {

constexpr int kRadius = 5;
constexpr double kDeviation = 1.5, kK1 = 0.01, kK2 = 0.03;

using Plane = std::vector<double>;

// Gaussian window sums; what lies outside of the image counts as 0.
Plane windowed(const Plane& in, int width, int height) {
    std::array<double, 2 * kRadius + 1> weights;
    for (int i = -kRadius; i <= kRadius; ++i) {
        weights[static_cast<std::size_t>(i + kRadius)] = std::exp(-i * i / (2 * kDeviation * kDeviation));
    }
    const auto place = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    Plane rows(in.size(), 0), out(in.size(), 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int i = std::max(-kRadius, -x); i <= std::min(kRadius, width - 1 - x); ++i) {
                rows[place(x, y)] += weights[static_cast<std::size_t>(i + kRadius)] * in[place(x + i, y)];
            }
        }
    }
    for (int y = 0; y < height; ++y) {
        for (int i = std::max(-kRadius, -y); i <= std::min(kRadius, height - 1 - y); ++i) {
            for (int x = 0; x < width; ++x) {
                out[place(x, y)] += weights[static_cast<std::size_t>(i + kRadius)] * rows[place(x, y + i)];
            }
        }
    }
    return out;
}

}  // namespace

std::vector<float> ssim(const ImageF& image, const ImageF& reference, double peak, const PixelMask& mask) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t count = image.pixels.size() / channels;
    Plane counted(count, 1);
    if (!mask.empty()) {
        std::ranges::copy(mask, counted.begin());
    }
    const Plane weight = windowed(counted, image.width, image.height);
    const double c1 = std::pow(kK1 * peak, 2), c2 = std::pow(kK2 * peak, 2);
    Plane sum(count, 0);
    for (std::size_t c = 0; c < channels; ++c) {
        Plane a(count), b(count), aa(count), bb(count), ab(count);
        for (std::size_t p = 0; p < count; ++p) {
            a[p] = counted[p] * image.pixels[p * channels + c];
            b[p] = counted[p] * reference.pixels[p * channels + c];
            aa[p] = a[p] * a[p];
            bb[p] = b[p] * b[p];
            ab[p] = a[p] * b[p];
        }
        for (Plane* plane : {&a, &b, &aa, &bb, &ab}) {
            *plane = windowed(*plane, image.width, image.height);
        }
        for (std::size_t p = 0; p < count; ++p) {
            if (counted[p] == 0) {
                continue;
            }
            const double w = 1 / weight[p];
            const double mean_a = a[p] * w, mean_b = b[p] * w;
            const double variance_a = std::max(aa[p] * w - mean_a * mean_a, 0.0);
            const double variance_b = std::max(bb[p] * w - mean_b * mean_b, 0.0);
            const double covariance = ab[p] * w - mean_a * mean_b;
            sum[p] += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
                      ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
        }
    }
    std::vector<float> result(count);
    std::ranges::transform(sum, result.begin(),
                           [&](double s) { return static_cast<float>(s / static_cast<double>(channels)); });
    return result;
}

}  // namespace lanthorn::workbench
