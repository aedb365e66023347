// What happens between frames: nothing when nothing changes, the same bits in every run, no pop when a map is
// exchanged.
#include <gtest/gtest.h>

#include <algorithm>

#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);

// A room with a block that stands in its middle or moves along x, and a lamp.
FrameScene room_with_block() {
    return scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                     box(vec3(-0.4f, 0, -0.8f), vec3(0.4f, 2.0f, 0.8f), false, 1)},
                    {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                    {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

void place_block(FrameScene& scene, float x) {
    move_instance(scene, 1, glm::translate(mat4(1), vec3(x, 0, 1.5f)));
}

double change(const std::vector<float>& a, const std::vector<float>& b) {
    double squares = 0;
    double mean = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        mean += b[i];
    }
    return std::sqrt(squares / static_cast<double>(a.size())) / (mean / static_cast<double>(a.size()));
}

TEST(Dynamics, AStillSceneRunsNothingAndKeepsItsImage) {
    Bench bench;
    FrameScene scene = room_with_block();
    place_block(scene, 2);
    const auto first = bench.frame(scene, kSize);
    hold_still(scene);
    for (int i = 0; i < 3; ++i) {
        const auto next = bench.frame(scene, kSize, true);
        EXPECT_EQ(next.pixels, first.pixels);
        for (const auto& span : bench.spans) {
            EXPECT_TRUE(span.name != "emission" && span.name != "bounces" && span.name != "splats" &&
                        span.name != "selection")
                << span.name;
        }
        const GiPlan plan = bench.technique().statistics(false).plan;
        for (const char* pass : {"emission", "splats", "environment_maps", "progressive_update"}) {
            EXPECT_FALSE(plan.on(pass)) << pass;
        }
    }
}

// Light maps keep a mover in a layer of its own for a while after it has come to rest: none of that is light.
TEST(Dynamics, PhotonsHoldOnceMotionHasEnded) {
    Bench bench;
    bench.settings.edit<EmcSettings>().update_interval = 1000;  // no exchange, which traces
    FrameScene scene = room_with_block();
    for (int i = 0; i < 6; ++i) {
        place_block(scene, 1 + 0.1f * static_cast<float>(i));
        bench.frame(scene, kSize);
        hold_still(scene);
    }
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("emission"));
    for (int i = 0; i < 6; ++i) {
        bench.frame(scene, kSize);
        EXPECT_FALSE(bench.technique().statistics(false).plan.on("emission")) << "frame " << i;
        hold_still(scene);
    }
}

// Error falls as frames accumulate, stops costing after the last pass, and motion begins anew with the same
// bits.
TEST(Dynamics, AStillPictureConverges) {
    constexpr float kLux = 100;
    FrameScene scene = scene_of({inward_sphere(1, 4, 0)}, {lambertian(vec3(0.5f))},
                                {point_light(vec3(0), kLux)}, vec3(0, 0, 0.5f), vec3(0, 0, -1));
    Bench bench;
    bench.settings.accumulate = 32;
    const auto first = bench.frame(scene, kSize);
    hold_still(scene);
    const double expected = kLux * 0.75;  // rho + rho^2
    double error = deviation_of(first, expected).rel_rmse;
    const double alone = error;
    for (const int passes : {8, 32}) {
        ImageF image;
        for (int pass = passes / 4; pass < passes; ++pass) {
            image = bench.frame(scene, kSize);
        }
        const Deviation now = deviation_of(image, expected);
        std::printf("closed sphere, %d passes: mean %.4f, relRMSE %.4f (one pass %.4f)\n", passes, now.mean,
                    now.rel_rmse, alone);
        EXPECT_NEAR(now.mean, 1, 0.02);
        EXPECT_LT(now.rel_rmse, 0.75 * error);
        error = now.rel_rmse;
    }
    const auto last = bench.frame(scene, kSize);
    EXPECT_EQ(bench.frame(scene, kSize).pixels, last.pixels);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("emission"));
    scene.changes.camera = true;
    EXPECT_EQ(bench.frame(scene, kSize).pixels, first.pixels);
}

TEST(Dynamics, TheSameSceneGivesTheSameBits) {
    FrameScene scene = room_with_block();
    place_block(scene, 2);
    Bench a;
    Bench b;
    EXPECT_EQ(a.frame(scene, kSize).pixels, b.frame(scene, kSize).pixels);
    // After a detour as well: a light that moves away and back.
    FrameScene moved = scene;
    hold_still(moved);
    moved.changes.lights = true;
    moved.lights[0].position.x += 0.5f;
    EXPECT_NE(b.frame(moved, kSize).pixels, a.frame(scene, kSize).pixels);
    FrameScene back = scene;
    hold_still(back);
    back.changes.lights = true;
    Bench c;
    const auto straight = c.frame(scene, kSize);
    EXPECT_EQ(b.frame(back, kSize).pixels, straight.pixels);
}

// What is kept of a pixel's surroundings (splat_boundaries.comp) must never outlive them.
TEST(Dynamics, WhatIsKeptGivesTheSameBitsAsAFreshStart) {
    FrameScene scene = room_with_block();
    place_block(scene, 2);
    Bench kept;
    kept.frame(scene, kSize);
    hold_still(scene);
    ivec2 size = kSize;
    const auto fresh_pixels = [&] {
        Bench fresh;
        fresh.settings = kept.settings;
        FrameScene all_new = scene;
        all_new.changes = room_with_block().changes;
        return fresh.frame(all_new, size).pixels;
    };
    const auto expect_same = [&](const char* what) {
        EXPECT_EQ(kept.frame(scene, size).pixels, fresh_pixels()) << what;
        hold_still(scene);
    };
    for (int i = 0; i < 3; ++i) {
        scene.lights[0].position.z += 0.3f;
        scene.changes.lights = true;
        expect_same("light moved");
    }
    const vec3 step(-0.2f, 0.1f, -0.3f);
    scene.camera.position += step;
    scene.camera.view = glm::translate(scene.camera.view, -step);
    scene.changes.camera = true;
    expect_same("camera moved");
    kept.settings.edit<EmcSettings>().splat_c0 *= 0.7f;
    expect_same("bandwidth constant changed");
    kept.settings.photons /= 2;
    expect_same("photons halved");
    kept.settings.edit<EmcSettings>().splat_base = SplatBase::quarter;
    expect_same("lowest level changed");
    size = ivec2(120, 72);
    scene.changes.camera = true;
    expect_same("size changed");
}

TEST(Dynamics, UpdatesComeEveryFiveFramesOfMotionAndExchangesFade) {
    Bench bench;
    FrameScene scene = room_with_block();
    place_block(scene, 0.5f);
    std::vector<float> last = bench.frame(scene, kSize).pixels;
    hold_still(scene);
    int updates = 0;
    int exchanges = 0;
    double largest_at_exchange = 0;
    double largest_otherwise = 0;
    auto& maps = static_cast<const EmcTechnique&>(bench.technique()).maps();
    std::vector<int> selected = maps.selected();
    for (int i = 1; i <= 40; ++i) {
        hold_still(scene);
        place_block(scene, 0.5f + 0.07f * static_cast<float>(i));
        const std::vector<float> now = bench.frame(scene, kSize).pixels;
        const bool updated = bench.technique().statistics(false).plan.on("progressive_update");
        EXPECT_EQ(updated, i > 5 && i % 5 == 2) << "frame " << i;
        updates += updated ? 1 : 0;
        const bool exchanged = maps.selected() != selected;
        exchanges += exchanged ? 1 : 0;
        selected = maps.selected();
        double& largest = exchanged || maps.fading() ? largest_at_exchange : largest_otherwise;
        largest = std::max(largest, change(now, last));
        last = now;
    }
    EXPECT_EQ(updates, 7);
    std::printf(
        "40 frames of a moving block: %d exchanges; largest change of a frame %.3f while fading, %.3f "
        "otherwise\n",
        exchanges, largest_at_exchange, largest_otherwise);
    EXPECT_GT(exchanges, 0);
    EXPECT_LT(largest_at_exchange, 2.0 * largest_otherwise);
}

// The look at candidates takes the same frames in every run, and ends when motion has ended: with the round
// in which is known that the one before, all of which came after the motion, has changed nothing.
TEST(Dynamics, UpdatesAreTheSameInEveryRunAndEndWithTheMotion) {
    struct Run {
        Bench bench;
        std::vector<std::vector<float>> pictures;
        std::vector<std::vector<int>> selected;
    };
    const auto run = [](Run& r) {
        FrameScene scene = room_with_block();
        place_block(scene, 0.5f);
        const auto& maps = static_cast<const EmcTechnique&>(r.bench.technique()).maps();
        for (int i = 0; i < 30; ++i) {
            r.pictures.push_back(r.bench.frame(scene, kSize).pixels);
            r.selected.push_back(maps.selected());
            const GiPlan plan = r.bench.technique().statistics(false).plan;
            EXPECT_EQ(plan.on("coverage"), i > 0 && i <= 22) << "frame " << i;
            hold_still(scene);
            if (i < 13) {
                place_block(scene, 0.5f + 0.2f * static_cast<float>(i + 1));
            }
        }
    };
    Run one;
    Run other;
    run(one);
    run(other);
    EXPECT_EQ(one.pictures, other.pictures);
    EXPECT_EQ(one.selected, other.selected);
}

TEST(Dynamics, EveryLightTypeGivesIndirectLightAndNoNaN) {
    const auto mean = [](const std::vector<float>& pixels) {
        double sum = 0;
        for (float v : pixels) {
            EXPECT_TRUE(std::isfinite(v));
            sum += v;
        }
        return sum / static_cast<double>(pixels.size());
    };
    FrameScene scene = room_with_block();
    place_block(scene, 2);
    scene.lights = {spot_light(vec3(0.6f, 2.2f, 1.5f), vec3(0, -1, 0), 100, 0.6f)};
    EXPECT_GT(mean(Bench().frame(scene, kSize).pixels), 0.1);
    scene.lights = {
        spot_light(vec3(0.6f, 2.2f, 1.5f), vec3(0, -1, 0), 100, 0.5f * kPi)};  // a cube map's spot
    EXPECT_GT(mean(Bench().frame(scene, kSize).pixels), 0.1);
    // Sun on an open terrace: a floor and a wall.
    FrameScene terrace = scene_of(
        {quad(vec3(0), vec3(0, 0, 4), vec3(4, 0, 0), 0), quad(vec3(0), vec3(0, 3, 0), vec3(0, 0, 4), 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, {point_light(vec3(0), 1000)},
        vec3(3.9f, 1.5f, 3.9f), vec3(0, 0.5f, 1));
    terrace.lights[0].light.type = LightType::directional;
    terrace.lights[0].direction = glm::normalize(vec3(-1, -1, 0));
    EXPECT_GT(mean(Bench().frame(terrace, kSize).pixels), 1);
    // An emissive ceiling panel alone.
    auto assets = std::make_shared<SceneAssets>(*scene.assets);
    Material lamp = lambertian(vec3(0));
    lamp.emissive = vec3(500);
    assets->materials.push_back(lamp);
    assets->meshes.push_back(quad(vec3(1.5f, 2.59f, 1), vec3(1, 0, 0), vec3(0, 0, 1), 2));
    FrameScene panel = scene_of(assets, {}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    EXPECT_GT(mean(Bench().frame(panel, kSize).pixels), 1);
}

TEST(Dynamics, NothingToLightOrToLightWithIsNotAnError) {
    FrameScene dark = room_with_block();
    dark.lights.clear();
    Bench bench;
    for (float v : bench.frame(dark, kSize).pixels) {
        ASSERT_EQ(v, 0.0f);
    }
    FrameScene empty =
        scene_of({}, {lambertian(vec3(0.5f))}, {point_light(vec3(0), 1)}, vec3(0, 0, 1), vec3(0));
    for (float v : Bench().frame(empty, kSize).pixels) {
        ASSERT_EQ(v, 0.0f);
    }
}

// Where the maps are is where the technique looks from.
TEST(Dynamics, MapsAreEyes) {
    Bench bench;
    bench.settings.edit<EmcSettings>().count = 3;
    bench.settings.edit<EmcSettings>().resolution = 64;
    DetailHints hints;
    const dvec3 origin(100, 0, 0);
    bench.technique().add_eyes(hints, origin);
    EXPECT_TRUE(hints.eyes.empty()) << "no map is drawn yet";
    FrameScene scene = room_with_block();
    place_block(scene, 2);
    bench.frame(scene, kSize);
    bench.technique().add_eyes(hints, origin);
    const EnvironmentMaps& maps = static_cast<const EmcTechnique&>(bench.technique()).maps();
    ASSERT_EQ(hints.eyes.size(), static_cast<std::size_t>(maps.count()));
    for (std::size_t i = 0; i < hints.eyes.size(); ++i) {
        const vec3& centre = maps.candidates()[static_cast<std::size_t>(maps.selected()[i])];
        EXPECT_EQ(hints.eyes[i].at, origin + dvec3(centre));
        EXPECT_NEAR(hints.eyes[i].samples_per_radian, 64 / (0.5 * kPi), 1e-3);
    }
    EXPECT_EQ(hints.samples_per_metre, 0);
}

}  // namespace
}  // namespace lanthorn::gi::test
