#include "tools/workbench/render/shown_as.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/core/colour.h"

namespace lanthorn::workbench {

namespace {

using Shown = gi::DebugView::Shown;

constexpr float kMeanGrey = 0.18f;  // what the mean of lit pixels becomes

// What one in kOutliers is above: a few wild ones would leave all others black.
constexpr std::size_t kOutliers = 200;

float most_of(const std::vector<float>& pixels) {
    std::vector<float> amounts;
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
        if (std::isfinite(pixels[i]) && pixels[i] > 0) {
            amounts.push_back(pixels[i]);
        }
    }
    if (amounts.empty()) {
        return 0;
    }
    const auto place = amounts.end() - 1 - static_cast<std::ptrdiff_t>(amounts.size() / kOutliers);
    std::nth_element(amounts.begin(), place, amounts.end());
    return *place;
}

void show_amounts(std::vector<float>& pixels) {
    const float most = most_of(pixels);
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
        const vec3 colour = heat(most > 0 ? pixels[i] / most : 0);
        for (glm::length_t c = 0; c < 3; ++c) {
            pixels[i + static_cast<std::size_t>(c)] = colour[c];
        }
    }
}

float exposure_of(const std::vector<float>& pixels) {
    double sum = 0, count = 0;
    for (const float v : pixels) {
        if (std::isfinite(v) && v > 0) {
            sum += static_cast<double>(v);
            count += 1;
        }
    }
    return sum > 0 ? kMeanGrey / static_cast<float>(sum / count) : 1.0f;
}

}  // namespace

vec3 heat(float share) {
    const vec3 stops[] = {vec3(0), vec3(0.22f, 0.08f, 0.40f), vec3(0.66f, 0.18f, 0.37f),
                          vec3(0.96f, 0.50f, 0.15f), vec3(1, 1, 0.85f)};
    constexpr int kSteps = static_cast<int>(std::size(stops)) - 1;
    const float at = std::clamp(share, 0.0f, 1.0f) * kSteps;
    const int step = std::min(static_cast<int>(at), kSteps - 1);
    return glm::mix(stops[step], stops[step + 1], at - static_cast<float>(step));
}

ImageF shown_as(ImageF image, Shown shown) {
    if (shown == Shown::amount) {
        show_amounts(image.pixels);
        return image;
    }
    const float exposure = shown == Shown::light ? exposure_of(image.pixels) : 1.0f;
    for (float& v : image.pixels) {
        v = srgb_from_linear(std::clamp(v * exposure, 0.0f, 1.0f));
    }
    return image;
}

}  // namespace lanthorn::workbench
