// The figure and the tint of a picture's error: of pictures whose error is known.
#include "tools/editor/core/error_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/core/colour.h"
#include "lanthorn/reference/path_tracer.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::editor {
namespace {

constexpr ivec2 kSize{96, 64};

class KnownError : public testing::Test {
  protected:
    KnownError()
        : scene(support::scene_of({support::box({-3, 0, -2}, {3, 3, 2}, true, 0),
                                   support::box({-1, 0, -1}, {-0.2f, 1.2f, 0}, false, 0)},
                                  {support::lambertian(vec3(0.6f, 0.5f, 0.4f))},
                                  {support::point_light({1, 2.2f, 0.5f}, 100)}, vec3(0, 1.5f, 1.9f),
                                  vec3(0, 1, -2))) {
        reference::PathSettings settings;
        settings.spp = 512;
        settings.seed = 77;  // other numbers than those of the map
        reference::PathTracer tracer(scene, kSize, settings, {.indirect = true});
        tracer.render({});
        truth = {kSize.x, kSize.y, 3, tracer.image(reference::PathAov::indirect), {}};
    }
    ErrorMap of(const ImageF& picture, int spp) const {
        reference::SparsePaths paths(scene, kSize, kErrorStride, {});
        paths.trace(spp, {});
        return error_map(paths, picture);
    }
    FrameScene scene;
    ImageF truth;
};

TEST_F(KnownError, OfAFifthTooMuchIsSaid) {
    ImageF bright = truth;
    double mean = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); i += 3) {
        mean += luminance(dvec3(truth.pixels[i], truth.pixels[i + 1], truth.pixels[i + 2])) * 3 /
                static_cast<double>(truth.pixels.size());
    }
    double squared = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); i += 3) {
        const double lux = luminance(dvec3(truth.pixels[i], truth.pixels[i + 1], truth.pixels[i + 2]));
        squared += 0.04 * lux * lux / (lux * lux + 0.01 * mean * mean) * 3 /
                   static_cast<double>(truth.pixels.size());
    }
    for (float& v : bright.pixels) {
        v *= 1.2f;
    }
    const double local = std::sqrt(squared);
    const ErrorMap map = of(bright, 64);
    EXPECT_FALSE(map.within_noise);
    EXPECT_NEAR(map.local, local, 3 * map.uncertainty);
    EXPECT_LT(map.uncertainty, 0.2 * local);
    int bright_cells = 0, dark_cells = 0;
    for (const float error : map.error) {
        bright_cells += error > 0 ? 1 : 0;
        dark_cells += error < 0 ? 1 : 0;
    }
    EXPECT_GT(bright_cells, static_cast<int>(map.error.size()) / 2);
    EXPECT_LT(dark_cells, static_cast<int>(map.error.size()) / 50);
}

TEST_F(KnownError, OfThePictureItselfIsWithinTheNoise) {
    const ErrorMap map = of(truth, 16);
    EXPECT_LT(map.local, 3 * map.uncertainty);
    int tinted = 0;
    for (const float error : map.error) {
        tinted += error != 0 ? 1 : 0;
    }
    EXPECT_LT(tinted, static_cast<int>(map.error.size()) / 10);  // two standard errors: one in twenty
    EXPECT_EQ(map.cells, ivec2(24, 16));
}

// A dark corner in a right picture: there and nowhere else, and by its sign.
TEST_F(KnownError, OfOnePlaceIsThere) {
    ImageF dark = truth;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            for (int c = 0; c < 3; ++c) {
                dark.pixels[3 * static_cast<std::size_t>(y * kSize.x + x) + static_cast<std::size_t>(c)] *=
                    0.5f;
            }
        }
    }
    const ErrorMap map = of(dark, 64);
    int in = 0, out = 0;
    for (int cell = 0; cell < 24 * 16; ++cell) {
        const bool there = cell % 24 < 8 && cell / 24 < 8, near = cell % 24 < 10 && cell / 24 < 10;
        if (!there && near) {
            continue;  // judged together with what lies in it
        }
        if (map.error[static_cast<std::size_t>(cell)] < -0.2f) {
            ++(there ? in : out);
        }
    }
    EXPECT_GT(in, 48);
    EXPECT_LT(out, 16);
}

}  // namespace
}  // namespace lanthorn::editor
