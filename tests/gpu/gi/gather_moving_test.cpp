// gi.emc.final = gather where cameras and things move: what is known goes along, what is touched is found
// again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace gather_moving_test {

constexpr ivec2 kSize(128);
constexpr int kAllFrames = RememberedHits::kFrames;

reference::PathSettings by_two_bounces() {
    reference::PathSettings settings;
    settings.spp = 256;
    settings.bounces = 2;
    return settings;
}

// The camera walks sideways at 2 cm a frame, or turns by half a degree.
void move_camera(FrameScene& scene, int frame, bool turn) {
    const float step = static_cast<float>(frame);
    const vec3 at(3.7f, 1.5f, 2.8f - (turn ? 0 : 0.02f * step));
    const float angle = glm::radians(0.5f) * (turn ? step : 0);
    const vec3 ahead = vec3(1, 1, 1) - vec3(3.7f, 1.5f, 2.8f);
    support::look(scene, at,
                  at + vec3(ahead.x * std::cos(angle) - ahead.z * std::sin(angle), ahead.y,
                            ahead.x * std::sin(angle) + ahead.z * std::cos(angle)));
    scene.changes.camera = true;
}

// What is known moves with the surfaces: a walking picture is little worse than a still one of the same view,
// and far better than one that begins there.
TEST(Gather, AMovingCameraKeepsWhatItKnows) {
    for (const bool turn : {false, true}) {
        FrameScene scene = room_with_block();
        Bench walking;
        walking.settings = gathered_by_rays();
        walking.settings.edit<EmcSettings>().gather_grid = 2;
        move_camera(scene, 0, turn);
        ImageF moved = still_picture(walking, scene, kAllFrames, kSize);
        hold_still(scene);
        constexpr int kSteps = 24;
        std::uint64_t rays = 0;
        for (int f = 1; f <= kSteps; ++f) {
            move_camera(scene, f, turn);
            moved = walking.frame(scene, kSize);
            rays = walking.technique().statistics(false).of<GatherStatistics>().rays;
        }
        const std::vector<float> truth = path_picture(scene, kSize, by_two_bounces());
        const auto begun_there = [&](int frames) {
            Bench bench;
            bench.settings = walking.settings;
            FrameScene fresh = scene;
            fresh.changes = room_with_block().changes;
            return against(still_picture(bench, fresh, frames, kSize), truth).rel_rmse;
        };
        const double first = begun_there(1);
        const double still = begun_there(kAllFrames);
        const Deviation there = against(moved, truth);
        std::printf("camera %s: relRMSE %.4f, flux %.4f; still %.4f, first frame %.4f; rays %llu\n",
                    turn ? "turns" : "walks", there.rel_rmse, there.mean, still, first,
                    static_cast<unsigned long long>(rays));
        EXPECT_NEAR(there.mean, 1, 0.02);
        EXPECT_LT(there.rel_rmse, 1.2 * still);
        EXPECT_LT(there.rel_rmse, first);
        EXPECT_LT(rays, 64u * 64u * 4u * 2u);
    }
}

// A block slides at 3 cm a frame: what it crosses is traced again at once.
TEST(Gather, AMovingBlockLeavesNoGhost) {
    FrameScene scene = room_with_block();
    Bench moving;
    moving.settings = gathered_by_rays();
    moving.settings.edit<EmcSettings>().gather_grid = 2;
    ImageF moved = still_picture(moving, scene, kAllFrames, kSize);
    for (int f = 1; f <= 24; ++f) {
        hold_still(scene);
        move_instance(scene, 1, glm::translate(mat4(1), vec3(-0.03f * static_cast<float>(f), 0, 0)));
        moved = moving.frame(scene, kSize);
    }
    const std::vector<float> truth = path_picture(scene, kSize, by_two_bounces());
    Bench bench;
    bench.settings = moving.settings;
    FrameScene fresh = scene;
    fresh.changes = room_with_block().changes;
    const double still = against(still_picture(bench, fresh, kAllFrames, kSize), truth).rel_rmse;
    const Deviation there = against(moved, truth);
    std::printf("block slides: relRMSE %.4f, flux %.4f; at rest %.4f\n", there.rel_rmse, there.mean, still);
    EXPECT_NEAR(there.mean, 1, 0.02);
    EXPECT_LT(there.rel_rmse, 1.3 * still);
}

// Two posts as one mesh that deforms: they swing apart, in turns. `serial`: of its topology.
void swing_posts(FrameScene& scene, int frame, std::uint64_t serial) {
    const float time = 0.4f * static_cast<float>(frame);
    deform_instance(scene, 1, serial, [&](const vec3& p) {
        return p + vec3(0, 0, 0.1f * p.y * std::sin(time + (p.x > 2 ? 1.5f : 0)));
    });
}

// Without what shows the posts, which are red.
ImageF beside_posts(Bench& bench, ImageF image) {
    const ImageF albedo = bench.renderer().read(render::Aov::albedo);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::size_t red = i / channels * channels;
        image.pixels[i] = albedo.pixels[red] > 2 * albedo.pixels[red + 1] ? 0 : image.pixels[i];
    }
    return image;
}

// Rays beside the limbs of a figure are not traced again: little else is seen than where all are that cross
// the box around it, as they are when its topology is another in each frame. (Then its own points begin anew,
// while limbs carry theirs along: the posts are left out.) What a ray through the maps meets may be another
// texel then. Measured: 0.0027; 0.0041 where limbs count only where they are, 0.0079 where they do not at
// all.
TEST(Gather, WhatLimbsDoNotTouchIsKept) {
    Mesh posts = box(vec3(1.2f, 0, 1.4f), vec3(1.3f, 1.2f, 1.5f), false, 1);
    const Mesh other = box(vec3(2.7f, 0, 1.4f), vec3(2.8f, 1.2f, 1.5f), false, 1);
    const auto first = static_cast<std::uint32_t>(posts.vertices.size());
    posts.vertices.insert(posts.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t i : other.indices) {
        posts.indices.push_back(first + i);
    }
    posts.bounds.add(other.bounds);
    FrameScene scene =
        scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0), posts},
                 {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                 {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    Bench limbs, whole;
    limbs.settings = whole.settings = gathered_by_rays();
    std::uint64_t fewer = 0, all = 0;
    double worst = 0;
    for (int f = 0; f <= 6; ++f) {
        SCOPED_TRACE(f);
        if (f > 0) {
            hold_still(scene);
        }
        swing_posts(scene, f, 1'000'000);
        const ImageF image = beside_posts(limbs, limbs.frame(scene, kSize));
        fewer = limbs.technique().statistics(true).of<GatherStatistics>().rays;
        swing_posts(scene, f, 1'000'001 + static_cast<std::uint64_t>(f));
        const ImageF all_traced = beside_posts(whole, whole.frame(scene, kSize));
        worst = std::max(worst, against(image, all_traced.pixels).rel_rmse);
        all = whole.technique().statistics(true).of<GatherStatistics>().rays;
    }
    std::printf("posts that swing: %llu rays instead of %llu; relRMSE of the difference %.5f\n",
                static_cast<unsigned long long>(fewer), static_cast<unsigned long long>(all), worst);
    EXPECT_LT(worst, 0.0031);
    EXPECT_LT(static_cast<double>(fewer), 0.8 * static_cast<double>(all));
}

// Only lit texels that movers touch look at the maps and at the lights again: the same bits as if all did, as
// they do where something is painted and a light altered besides.
TEST(Gather, WhatMoversDoNotTouchStaysWhatItWas) {
    FrameScene scene = room_with_block();
    Bench some, all;
    some.settings = all.settings = gathered_by_rays();
    ImageF last;
    for (int f = 0; f <= 6; ++f) {
        SCOPED_TRACE(f);
        if (f > 0) {
            hold_still(scene);
            const float step = static_cast<float>(f);
            const mat4 there = glm::translate(mat4(1), step * vec3(-0.05f, 0.02f, 0));
            move_instance(scene, 1, glm::rotate(there, 0.02f * step, vec3(0, 1, 0)));
        }
        const ImageF image = some.frame(scene, kSize);
        if (f > 0) {
            scene.changes.painted = {0, 1};
            scene.changes.lights = true;
        }
        EXPECT_EQ(image.pixels, all.frame(scene, kSize).pixels);
        EXPECT_NE(image.pixels, last.pixels);
        last = image;
    }
}

}  // namespace gather_moving_test
}  // namespace lanthorn::gi::test
