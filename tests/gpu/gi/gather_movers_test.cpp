// What is remembered of rays that start on things that move and bend.
#include <gtest/gtest.h>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(64);
constexpr std::uint32_t kBlock = 1;
constexpr int kFrames = 24;
constexpr float kStep = 0.01f;  // metres a frame: less than surfaces may be apart and count as one

// Parts of a picture: the pixels that show the block of room_with_block(), which alone is red.
Deviation on_the_block(Bench& bench, const ImageF& image, const Truth& truth) {
    const ImageF albedo = bench.renderer().read(render::Aov::albedo);
    ImageF part;
    part.channels = image.channels;
    part.height = 1;
    Truth expected;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t p = 0; p < image.pixels.size() / channels; ++p) {
        if (albedo.pixels[channels * p] > 2 * albedo.pixels[channels * p + 1]) {
            ++part.width;
            for (std::size_t c = channels * p; c < channels * (p + 1); ++c) {
                part.pixels.push_back(image.pixels[c]);
                expected.halves[0].push_back(truth.halves[0][c]);
                expected.halves[1].push_back(truth.halves[1][c]);
            }
        }
    }
    return against(part, expected);
}

// `move`: puts the block where it is in a frame.
void expect_lit_while_it_moves(const char* what, const std::function<void(FrameScene&, int)>& move) {
    add_embree_rays();
    FrameScene scene = room_with_block();
    Bench bench;
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    bench.settings.edit<EmcSettings>().rays = EmcRays::bvh;
    bench.settings.edit<EmcSettings>().gather_points = 1;
    bench.settings.edit<EmcSettings>().gather_grid = 2;
    bench.settings.edit<EmcSettings>().gather_endless = false;
    move(scene, 0);
    still_picture(bench, scene, 16, kSize);
    ImageF image;
    for (int f = 1; f <= kFrames; ++f) {
        hold_still(scene);
        move(scene, f);
        image = bench.frame(scene, kSize);
    }
    const Deviation there = on_the_block(bench, image, path_traced(scene, kSize, 2, 192));
    std::printf("%s: on it relRMSE %.4f, flux %.4f\n", what, there.rel_rmse, there.mean);
    EXPECT_NEAR(there.mean, 1, 0.03);
    EXPECT_LT(there.rel_rmse, 0.08);
}

// Where a surface was a moment ago is inside of what comes on, and dark.
TEST(GatherMovers, WhatComesOnSlowlyKeepsItsLight) {
    expect_lit_while_it_moves("a block that comes on", [](FrameScene& scene, int f) {
        const float way = kStep * static_cast<float>(f);
        move_instance(scene, kBlock, glm::translate(mat4(1), vec3(way, 0, 0.5f * way)));
    });
}

TEST(GatherMovers, WhatBendsKeepsItsLight) {
    expect_lit_while_it_moves("a block that leans over", [](FrameScene& scene, int f) {
        const float way = kStep * static_cast<float>(f);
        deform_instance(scene, kBlock, 1'000'000,
                        [&](const vec3& p) { return p + p.y * vec3(way, 0, 0.5f * way); });
    });
}

}  // namespace
}  // namespace lanthorn::gi::test
