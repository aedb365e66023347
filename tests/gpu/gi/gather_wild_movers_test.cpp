// Things that move as nothing does in nature: what is remembered of them is worth nothing in any frame, and
// must neither stay in the picture nor break it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kWildSize(64);
constexpr std::uint32_t kWildBlock = 1;

void set_up(Bench& bench) {
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    bench.settings.edit<EmcSettings>().rays = EmcRays::bvh;
    bench.settings.edit<EmcSettings>().gather_points = 1;
    bench.settings.edit<EmcSettings>().gather_grid = 2;
    bench.settings.edit<EmcSettings>().gather_endless = false;
}

// Lux of the brightest pixel; fails the test at one that is not finite.
double brightest(const ImageF& image) {
    double most = 0;
    for (const float value : image.pixels) {
        EXPECT_TRUE(std::isfinite(value));
        most = std::max(most, static_cast<double>(value));
    }
    return most;
}

// `move`: what the scene is in a frame. Its last frame is held against the path tracer, all against a peak
// that the room never has.
void expect_right_in_the_end(const char* what, FrameScene scene, int frames, double rel_rmse,
                             const std::function<void(FrameScene&, int)>& move) {
    add_embree_rays();
    Bench bench;
    set_up(bench);
    move(scene, 0);
    ImageF image = bench.frame(scene, kWildSize);
    double most = brightest(image);
    for (int f = 1; f <= frames; ++f) {
        hold_still(scene);
        move(scene, f);
        image = bench.frame(scene, kWildSize);
        most = std::max(most, brightest(image));
    }
    const Truth truth = path_traced(scene, kWildSize, 2, 192);
    double peak = 0;
    for (const float value : truth.halves[0]) {
        peak = std::max(peak, static_cast<double>(value));
    }
    const Deviation last = against(image, truth);
    std::printf("%s: relRMSE %.4f, flux %.4f, brightest %.1f of %.1f lux\n", what, last.rel_rmse, last.mean,
                most, peak);
    EXPECT_NEAR(last.mean, 1, 0.05);
    EXPECT_LT(last.rel_rmse, rel_rmse);
    EXPECT_LT(most, 8 * peak);
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0U);
}

TEST(WildMovers, WhatBlinksLeavesNoGhost) {
    expect_right_in_the_end("a block that blinks", room_with_block(), 13, 0.2, [](FrameScene& scene, int f) {
        move_instance(scene, kWildBlock, glm::translate(mat4(1), vec3(f % 2 == 1 ? 50.0f : 0.0f, 0, 0)));
    });
}

TEST(WildMovers, WhatLeapsIsLitWhereItArrives) {
    expect_right_in_the_end("a block that leaps", room_with_block(), 12, 0.2, [](FrameScene& scene, int f) {
        const float x = std::sin(12.9898f * static_cast<float>(f)),
                    z = std::sin(78.233f * static_cast<float>(f));
        move_instance(scene, kWildBlock, glm::translate(mat4(1), vec3(x, 0, 0.5f * z)));
    });
}

TEST(WildMovers, WhatTurnsHalfAroundAFrameIsLit) {
    expect_right_in_the_end("a block that spins", room_with_block(), 12, 0.2, [](FrameScene& scene, int f) {
        const vec3 middle(2, 0, 1.5f);
        const mat4 turn =
            glm::rotate(mat4(1), (std::numbers::pi_v<float> - 0.4f) * static_cast<float>(f), vec3(0, 1, 0));
        move_instance(scene, kWildBlock,
                      glm::translate(mat4(1), middle) * turn * glm::translate(mat4(1), -middle));
    });
}

// Each a box that carries a lamp above it.
TEST(WildMovers, AHundredLampsAreCarriedAbout) {
    constexpr int kSide = 10;
    std::vector<Mesh> meshes{box(vec3(0), vec3(6, 2.6f, 6), true, 0)};
    std::vector<LightInstance> lamps;
    for (int i = 0; i < kSide * kSide; ++i) {
        const vec3 at(0.5f + 0.55f * static_cast<float>(i % kSide), 0,
                      0.5f + 0.55f * static_cast<float>(i / kSide));
        meshes.push_back(box(at, at + vec3(0.12f, 0.8f, 0.12f), false, 1));
        lamps.push_back(point_light(at + vec3(0.06f, 0.9f, 0.06f), 3));
    }
    const FrameScene scene = scene_of(meshes, {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                                      lamps, vec3(5.8f, 2.4f, 5.8f), vec3(2.5f, 0.5f, 2.5f));
    expect_right_in_the_end("a hundred lamps", scene, 6, 0.5, [&](FrameScene& s, int f) {
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            const float way = 0.02f * static_cast<float>(f) * (i % 2 == 0 ? 1.0f : -1.0f);
            move_instance(s, 1 + i, glm::translate(mat4(1), vec3(way, 0, 0)));
            s.lights[i].position = lamps[i].position + vec3(way, 0, 0);
        }
        s.changes.lights = true;
    });
}

}  // namespace
}  // namespace lanthorn::gi::test
