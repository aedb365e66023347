#include "tests/gpu/gi/path_truth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/reference/path_tracer.h"

namespace lanthorn::gi::test {

std::vector<float> path_picture(const FrameScene& scene, ivec2 size, const reference::PathSettings& settings,
                                reference::PathAov what) {
    const bool radiance = what == reference::PathAov::radiance;
    reference::PathTracer tracer(scene, size, settings, {.indirect = true, .radiance = radiance});
    tracer.render({});
    return tracer.image(what);
}

Truth path_traced(const FrameScene& scene, ivec2 size, int bounces, int spp, reference::PathAov what) {
    Truth truth;
    reference::PathSettings settings;
    settings.spp = spp / 2;
    settings.bounces = bounces;
    for (std::vector<float>& half : truth.halves) {
        half = path_picture(scene, size, settings, what);
        ++settings.seed;
    }
    return truth;
}

Deviation against(const ImageF& image, const Truth& truth) {
    double sum = 0;
    double wanted = 0;
    double squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto got = static_cast<double>(image.pixels[i]);
        const auto a = static_cast<double>(truth.halves[0][i]);
        const auto b = static_cast<double>(truth.halves[1][i]);
        EXPECT_TRUE(std::isfinite(got)) << i;
        sum += got;
        wanted += 0.5 * (a + b);
        squares += (got - a) * (got - b);
    }
    const auto n = static_cast<double>(image.pixels.size());
    return {sum / wanted, std::sqrt(std::max(squares, 0.0) / n) / (wanted / n)};
}

Deviation against(const ImageF& image, const std::vector<float>& expected) {
    return against(image, Truth{{expected, expected}});
}

}  // namespace lanthorn::gi::test
