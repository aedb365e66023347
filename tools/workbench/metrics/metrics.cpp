#include "lanthorn/workbench/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lanthorn/core/error.h"

namespace lanthorn::workbench {

namespace {

void check_finite(const ImageF& image, const std::string& name) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (!std::isfinite(image.pixels[i])) {
            const std::size_t pixel = i / static_cast<std::size_t>(image.channels);
            const std::size_t width = static_cast<std::size_t>(image.width);
            throw InputError(name,
                             fmt::format("pixel ({}, {}) channel {}", pixel % width, pixel / width,
                                         i % static_cast<std::size_t>(image.channels)),
                             fmt::format("found {}, expected finite values", image.pixels[i]));
        }
    }
}

// Sums that a Difference is made of.
struct Sums {
    double square = 0, absolute = 0, largest = 0, image = 0, reference = 0;
    std::size_t count = 0;

    void add(double a, double b) {
        const double d = a - b;
        square += d * d;
        absolute += std::abs(d);
        largest = std::max(largest, std::abs(d));
        image += a;
        reference += b;
        ++count;
    }
    Difference difference() const {
        const auto n = static_cast<double>(std::max<std::size_t>(count, 1));
        Difference result;
        result.mean = image / n;
        result.reference_mean = reference / n;
        result.rmse = std::sqrt(square / n);
        result.mae = absolute / n;
        result.max = largest;
        result.relrmse =
            result.reference_mean != 0 ? result.rmse / std::abs(result.reference_mean) : std::nan("");
        result.flux = result.reference_mean != 0 ? result.mean / result.reference_mean : std::nan("");
        result.bias = result.flux - 1;
        return result;
    }
};

bool is_lit(float v) {
    return v != 0;
}

}  // namespace

PixelMask lit_pixels(const ImageF& image) {
    const auto channels = static_cast<std::size_t>(image.channels);
    PixelMask mask;
    mask.reserve(image.pixels.size() / channels);
    for (std::size_t p = 0; p < image.pixels.size(); p += channels) {
        mask.push_back(std::any_of(&image.pixels[p], &image.pixels[p] + channels, is_lit) ? 1 : 0);
    }
    return mask;
}

double mean_over(const std::vector<float>& values, const PixelMask& mask) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (mask.empty() || mask[i] != 0) {
            sum += values[i];
            ++count;
        }
    }
    return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

Comparison compare(const ImageF& image, const ImageF& reference, const std::string& image_name,
                   const std::string& reference_name, const PixelMask& mask) {
    if (image.width != reference.width || image.height != reference.height ||
        image.channels != reference.channels) {
        throw InputError(image_name, "",
                         fmt::format("found {} x {} pixels of {} channels, expected {} x {} of {} as in {}",
                                     image.width, image.height, image.channels, reference.width,
                                     reference.height, reference.channels, reference_name));
    }
    check_finite(image, image_name);
    check_finite(reference, reference_name);

    const auto channels = static_cast<std::size_t>(image.channels);
    Sums all;
    std::vector<Sums> by_channel(channels);
    Comparison result;
    result.pixels = image.pixels.size() / channels;
    result.valid.assign(result.pixels, 0);
    std::size_t looked_at = 0;
    float lowest = 0, highest = 1, reference_peak = 0;
    for (std::size_t p = 0; p < image.pixels.size(); p += channels) {
        const float* a = &image.pixels[p];
        const float* b = &reference.pixels[p];
        for (std::size_t c = 0; c < channels; ++c) {
            lowest = std::min({lowest, a[c], b[c]});
            highest = std::max({highest, a[c], b[c]});
            reference_peak = std::max(reference_peak, b[c]);
        }
        if (!mask.empty() && mask[p / channels] == 0) {
            continue;
        }
        ++looked_at;
        if (!std::any_of(a, a + channels, is_lit) && !std::any_of(b, b + channels, is_lit)) {
            continue;
        }
        ++result.valid_pixels;
        result.valid[p / channels] = 1;
        for (std::size_t c = 0; c < channels; ++c) {
            all.add(a[c], b[c]);
            by_channel[c].add(a[c], b[c]);
        }
    }
    if (!(std::abs(all.reference) > 0)) {
        throw InputError(reference_name, "", "found a mean of 0, expected a reference with light in it");
    }
    result.all = all.difference();
    for (const Sums& sums : by_channel) {
        result.channels.push_back(sums.difference());
    }
    result.peak = lowest >= 0 && highest <= 1 ? 1.0 : reference_peak;
    const double mse = all.square / static_cast<double>(looked_at * channels);
    result.psnr = mse > 0 ? 10 * std::log10(result.peak * result.peak / mse) : HUGE_VAL;
    return result;
}

std::vector<float> relative_error(const ImageF& image, const ImageF& reference, double reference_mean) {
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<float> error(image.pixels.size() / channels);
    for (std::size_t p = 0; p < error.size(); ++p) {
        double sum = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            sum += std::abs(double(image.pixels[p * channels + c]) - reference.pixels[p * channels + c]);
        }
        error[p] = static_cast<float>(sum / static_cast<double>(channels) / std::abs(reference_mean));
    }
    return error;
}

ImageF heat_map(const std::vector<float>& values, int width, int height) {
    constexpr std::array<std::array<float, 3>, 5> kStops = {
        {{0, 0, 0}, {0.34f, 0.06f, 0.43f}, {0.83f, 0.21f, 0.25f}, {0.98f, 0.65f, 0.15f}, {1, 1, 1}}};
    ImageF image;
    image.width = width;
    image.height = height;
    image.channels = 3;
    image.pixels.reserve(3 * values.size());
    for (const float value : values) {
        const float x = std::clamp(value, 0.0f, 1.0f) * (kStops.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(x), kStops.size() - 2);
        const float t = x - static_cast<float>(i);
        for (std::size_t c = 0; c < 3; ++c) {
            image.pixels.push_back((1 - t) * kStops[i][c] + t * kStops[i + 1][c]);
        }
    }
    return image;
}

}  // namespace lanthorn::workbench
