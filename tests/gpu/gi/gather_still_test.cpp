// What the final gather makes of a scene in which nothing changes: the reference's light, the longer the
// nearer, and none of it once something does change.
#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

constexpr int kAllFrames = RememberedHits::kFrames;

GiSettings gather_settings() {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;  // by photons: lit_photons_test.cpp
    settings.edit<EmcSettings>().gather_grid = 2;
    settings.edit<EmcSettings>().gather_points = 1;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

FrameScene room_with_block() {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 2.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
        {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

// Measured: 0.0722 when all is remembered, 0.0552, 0.0416, 0.0359 and 0.0323 after 48, 96, 144 and 192
// passes: N^-0.39 from the first of these to the last.
TEST(GatherStill, AStillPictureConverges) {
    constexpr ivec2 kSize(64);
    constexpr int kPasses = 192;
    FrameScene scene = room_with_block();
    const Truth truth = path_traced(scene, kSize, 2, 2048);
    Bench bench;
    bench.settings = gather_settings();
    bench.settings.accumulate = kPasses;
    double before = 0;
    double after = 0;
    double worst = 0;
    ImageF image;
    for (int f = 0; f < kAllFrames + kPasses; ++f) {
        image = bench.frame(scene, kSize);
        hold_still(scene);
        const double error = against(image, truth).rel_rmse;
        if (f < kAllFrames - 1) {
            continue;
        }
        if (f >= kAllFrames) {
            worst = std::max(worst, error / after);
        }
        after = error;
        before = f == kAllFrames - 1 ? error : before;
        if (f % 48 == kAllFrames - 1) {
            std::printf("still room, %d frames: relRMSE %.4f, flux %.4f\n", f + 1, error,
                        against(image, truth).mean);
        }
    }
    std::printf("still room: %.4f to %.4f, no frame more than %.4f of the one before\n", before, after,
                worst);
    EXPECT_LT(after, 0.035);  // measured 0.0323, from 0.0722
    EXPECT_LT(worst, 1.002);
    EXPECT_NEAR(against(image, truth).mean, 1, 0.02);
    // It stays, and costs nothing.
    EXPECT_EQ(bench.frame(scene, kSize, true).pixels, image.pixels);
    const GiPlan plan = bench.technique().statistics(false).plan;
    EXPECT_FALSE(plan.on("accumulation") || plan.on("gather"));
}

// A change of view or surfaces finds what the gather remembered, as if no pass had been.
TEST(GatherStill, WhatChangesEndsThePasses) {
    constexpr ivec2 kSize(64);
    enum Change { camera, geometry };
    for (const Change change : {camera, geometry}) {
        const auto picture = [&](int accumulate) {
            Bench bench;
            bench.settings = gather_settings();
            bench.settings.accumulate = accumulate;
            FrameScene scene = room_with_block();
            std::vector<ImageF> images;
            for (int f = 0; f < kAllFrames + 9; ++f) {
                images.push_back(bench.frame(scene, kSize));
                hold_still(scene);
            }
            if (change == camera) {
                support::look(scene, vec3(3.7f, 1.5f, 2.7f), vec3(1, 1, 1));
                scene.changes.camera = true;
            } else {
                move_instance(scene, 1, glm::translate(mat4(1), vec3(-0.2f, 0, 0)));
            }
            images.push_back(bench.frame(scene, kSize));
            EXPECT_TRUE(bench.technique().statistics(false).plan.on("gather"));
            EXPECT_FALSE(bench.technique().statistics(false).plan.on("accumulation"));
            return images;
        };
        const std::vector<ImageF> plain = picture(1);
        const std::vector<ImageF> refined = picture(1000);
        EXPECT_EQ(plain[kAllFrames - 1].pixels, refined[kAllFrames - 1].pixels);
        EXPECT_NE(plain[kAllFrames + 8].pixels, refined[kAllFrames + 8].pixels);
        EXPECT_EQ(plain.back().pixels, refined.back().pixels) << change;
    }
}

// Light alone changes: from the refined picture to what the gather remembers within nine frames, without a
// jump, and meanwhile with less error than without passes.
TEST(GatherStill, LightThatChangesFindsNoJump) {
    constexpr ivec2 kSize(64);
    constexpr int kPasses = 96, kMoves = 9;
    struct Run {
        std::vector<ImageF> images;  // the last at rest, then of each move
        FrameScene scene;
    };
    const auto run = [&](int accumulate) {
        Bench bench;
        bench.settings = gather_settings();
        bench.settings.accumulate = accumulate;
        Run result;
        result.scene = room_with_block();
        for (int f = 0; f < kAllFrames + kPasses + kMoves; ++f) {
            if (f >= kAllFrames + kPasses) {
                result.scene.lights[0].position.x += 0.005f;
                result.scene.changes.lights = true;
            }
            const ImageF image = bench.frame(result.scene, kSize);
            if (f >= kAllFrames + kPasses - 1) {
                result.images.push_back(image);
            }
            hold_still(result.scene);
            if (f == kAllFrames + kPasses) {
                EXPECT_TRUE(bench.technique().statistics(false).plan.on("gather"));
            }
        }
        return result;
    };
    const auto change = [](const ImageF& a, const ImageF& b) {
        double squares = 0, sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            squares += std::pow(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]), 2);
            sum += static_cast<double>(b.pixels[i]);
        }
        const auto n = static_cast<double>(a.pixels.size());
        return std::sqrt(squares / n) / (sum / n);
    };
    const Run plain = run(1), refined = run(kPasses + 1);
    const double light = change(plain.images[1], plain.images[0]);  // of the light itself
    const double jump = change(plain.images[1], refined.images[0]);
    double most = 0;
    for (int i = 1; i <= kMoves; ++i) {
        most = std::max(most, change(refined.images[static_cast<std::size_t>(i)],
                                     refined.images[static_cast<std::size_t>(i) - 1]));
    }
    std::printf("light moves: %.4f a frame; without a fade %.4f at once, with one %.4f at most\n", light,
                jump, most);
    EXPECT_GT(jump, 2 * light) << "there was nothing to fade";
    EXPECT_LT(most, 0.5 * jump);
    EXPECT_EQ(plain.images.back().pixels, refined.images.back().pixels);
    FrameScene after_two = room_with_block();
    after_two.lights[0].position.x += 0.01f;
    const Truth truth = path_traced(after_two, kSize, 2, 2048);
    const double with = against(refined.images[2], truth).rel_rmse,
                 without = against(plain.images[2], truth).rel_rmse;
    std::printf("after two frames: relRMSE %.4f, without passes %.4f\n", with, without);
    EXPECT_LT(with, 0.9 * without);
}

// An error that is wished for ends the passes once it is estimated to be reached.
TEST(GatherStill, PassesEndWhenTheErrorIsReached) {
    constexpr ivec2 kSize(64);
    constexpr float kTarget = 0.05f;
    FrameScene scene = room_with_block();
    Bench bench;
    bench.settings = gather_settings();
    bench.settings.accumulate = 1000;
    bench.settings.target_error = kTarget;
    int passes = 0;
    double before = 0;
    for (int f = 0; f < kAllFrames + 400; ++f) {
        bench.frame(scene, kSize);
        hold_still(scene);
        const bool refines = bench.technique().statistics(false).plan.on("accumulation");
        if (!refines && f >= kAllFrames) {
            break;
        }
        passes += refines ? 1 : 0;
        before = passes == 3 ? bench.technique().estimate_error().relrmse.value : before;
    }
    const double after = bench.technique().estimate_error().relrmse.value;
    std::printf("passes until %.2f: %d, estimated %.4f before and %.4f after\n", kTarget, passes, before,
                after);
    EXPECT_GT(before, kTarget) << "there was nothing to do";
    EXPECT_LE(after, kTarget);
    EXPECT_LT(passes, 400);
    const ImageF reached = bench.frame(scene, kSize);
    // A lower error goes on from there, and a change of view begins as ever.
    bench.settings.target_error = 0.8f * kTarget;
    bench.frame(scene, kSize);
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("accumulation"));
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("gather"));
}

// Allowing more passes while they go on, or after, is no other picture: it goes on, to the same bits.
TEST(GatherStill, MorePassesGoOnWithThePicture) {
    constexpr ivec2 kSize(50, 37);
    const auto picture = [](int first, int then) {
        Bench bench;
        bench.settings = gather_settings();
        bench.settings.accumulate = first;
        FrameScene scene = room_with_block();
        ImageF image;
        for (int f = 0; f < kAllFrames + 40; ++f) {
            bench.settings.accumulate = f < kAllFrames + 10 ? first : then;
            image = bench.frame(scene, kSize);
            EXPECT_EQ(bench.technique().statistics(false).plan.on("gather"), f < kAllFrames) << f;
            hold_still(scene);
        }
        return image.pixels;
    };
    EXPECT_EQ(picture(5, 25), picture(25, 25));
    EXPECT_EQ(picture(20, 25), picture(25, 25));
}

TEST(GatherStill, TheSameSceneGivesTheSameBits) {
    const auto picture = [] {
        Bench bench;
        bench.settings = gather_settings();
        bench.settings.accumulate = 20;
        FrameScene scene = room_with_block();
        ImageF image;
        for (int f = 0; f < kAllFrames + 20; ++f) {
            image = bench.frame(scene, ivec2(50, 37));
            hold_still(scene);
        }
        return image.pixels;
    };
    EXPECT_EQ(picture(), picture());
}

// Indirect light on lit maps that is blurred goes from where there is much to where there is little, bounce
// by bounce: round the corner of the corridor it was 1.12 of what arrives.
TEST(GatherStill, ManyBouncesRoundACornerAreNotCarriedByBlur) {
    constexpr ivec2 kSize(48);
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/corridor.glb")));
    Transforms().update(world);
    Camera camera;
    camera.y_fov = glm::radians(60.0f);
    FrameScene scene = Extractor().extract(
        world, camera, glm::inverse(glm::lookAt(dvec3(-6.6, 1.6, 1.1), dvec3(0.4, 1, 0.8), dvec3(0, 1, 0))));
    Bench bench;
    bench.settings = gather_settings();
    bench.settings.bounces = 8;
    const Truth truth = path_traced(scene, kSize, 8, 1024);
    ImageF image;
    for (int f = 0; f < kAllFrames; ++f) {
        image = bench.frame(scene, kSize);
        hold_still(scene);
    }
    const double flux = against(image, truth).mean;
    std::printf("round a corner, 8 bounces: flux %.4f\n", flux);
    EXPECT_NEAR(flux, 1, 0.04);
}

}  // namespace
}  // namespace lanthorn::gi::test
