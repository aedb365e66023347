// What frames of a game may ask of both final stages at their worst: many lamps, a lamp after long darkness,
// another view, size or memory in every frame, things that jump. Light must be right at once, and nothing may
// grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gl_objects.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(80);
constexpr int kBounces = 2;
constexpr int kAllFrames = RememberedHits::kFrames;
// A first frame errs at most twice as much as a settled one; or no more than is allowed where light moves.
constexpr double kFirst = 2;
constexpr double kAllowed = 0.09;

// Frames after a change in which rounds of the progressive update end, and what is remembered is in again: 25
// as measured.
constexpr int kSettled = 2 * RememberedHits::kFrames;

class Hardships : public ::testing::TestWithParam<EmcFinal> {
  protected:
    GiSettings settings() const {
        GiSettings s;
        s.bounces = kBounces;
        s.edit<EmcSettings>().gather_endless = false;
        s.edit<EmcSettings>().final_stage = GetParam();
        s.edit<EmcSettings>().gather_grid = 1;  // pictures are small: as many points as at 320x320 by default
        return s;
    }
    // relRMSE of a picture that begins with this scene, once nothing is to be learnt from more frames.
    double settled_error(const FrameScene& scene, const Truth& truth) const;
};

std::string name_of(const ::testing::TestParamInfo<EmcFinal>& info) {
    return info.param == EmcFinal::gather ? "gather" : "splat";
}

INSTANTIATE_TEST_SUITE_P(FinalStages, Hardships, ::testing::Values(EmcFinal::splat, EmcFinal::gather),
                         name_of);

// Two closed rooms, the second 10 m along x, with a block in the first.
FrameScene two_rooms(float first_lamp, float second_lamp) {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(10, 0, 0), vec3(13, 2.2f, 4), true, 1),
         box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 1.8f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
        {point_light(vec3(0.6f, 2.2f, 1.5f), first_lamp), point_light(vec3(12.5f, 1.6f, 1), second_lamp)},
        vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

// The views that a camera jumps between: two of each room.
constexpr int kViews = 4;
void look_from(FrameScene& scene, int view) {
    constexpr vec3 kEyes[kViews] = {
        {3.7f, 1.5f, 2.8f}, {10.4f, 1.2f, 3.6f}, {0.5f, 2.1f, 0.4f}, {12.7f, 0.6f, 0.5f}};
    constexpr vec3 kTargets[kViews] = {{1, 1, 1}, {12, 1, 1}, {3.5f, 0.3f, 2.5f}, {10.5f, 1.2f, 3}};
    support::look(scene, kEyes[view], kTargets[view]);
    scene.changes.camera = true;
}

// As if the scene had never been seen.
FrameScene all_new(FrameScene scene) {
    scene.changes = two_rooms(1, 1).changes;
    return scene;
}

Truth truth_of(const FrameScene& scene, ivec2 size) {
    return path_traced(scene, size, kBounces, 256);
}

// Of two_rooms(100, 20) by its first view.
const Truth& truth_of_the_first_room() {
    static const Truth traced = truth_of(two_rooms(100, 20), kSize);
    return traced;
}

void expect_finite(const ImageF& image) {
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return std::isfinite(v) && v >= 0; }));
}

std::uint64_t bad_values(Bench& bench) {
    return bench.technique().statistics(false).nan_count + bench.renderer().nan_count();
}

// Enough frames that nothing is to be learnt from more.
ImageF settled(Bench& bench, FrameScene scene, ivec2 size = kSize) {
    ImageF image = bench.frame(scene, size);
    hold_still(scene);
    for (int f = 0; f < kAllFrames; ++f) {
        image = bench.frame(scene, size);
    }
    return image;
}

double Hardships::settled_error(const FrameScene& scene, const Truth& truth) const {
    Bench bench;
    bench.settings = settings();
    return against(settled(bench, all_new(scene)), truth).rel_rmse;
}

TEST_P(Hardships, AHundredLampsLightARoom) {
    FrameScene scene = two_rooms(0, 0);
    scene.lights.clear();
    for (int i = 0; i < 100; ++i) {
        const float u = static_cast<float>(i % 10);
        const float v = static_cast<float>(i / 10);
        scene.lights.push_back(point_light(vec3(0.2f + 0.4f * u, 2 - 0.05f * (u + v), 0.15f + 0.3f * v), 2));
        scene.lights.back().light.colour = vec3(1, 0.5f + 0.05f * u, 0.5f + 0.05f * v);
        scene.lights.back().id = 1000 + static_cast<std::uint32_t>(i);
    }
    const Truth truth = truth_of(scene, kSize);
    Bench bench;
    bench.settings = settings();
    const Deviation first = against(bench.frame(scene, kSize), truth);
    hold_still(scene);
    const GlObjects before = gl_objects();
    ImageF image;
    for (int f = 0; f < kAllFrames; ++f) {
        scene.lights[static_cast<std::size_t>(6 * f)].light.intensity = 2 + 0.01f * static_cast<float>(f);
        scene.changes.lights = true;
        image = bench.frame(scene, kSize);
    }
    const Deviation last = against(image, truth);
    std::printf("100 lamps: first frame relRMSE %.4f, flux %.4f; after %d more %.4f, %.4f\n", first.rel_rmse,
                first.mean, kAllFrames, last.rel_rmse, last.mean);
    EXPECT_NEAR(first.mean, 1, 0.03);
    EXPECT_NEAR(last.mean, 1, 0.03);
    EXPECT_LT(first.rel_rmse, 0.2);
    EXPECT_LT(last.rel_rmse, 0.2);
    EXPECT_EQ(bad_values(bench), 0u);
    EXPECT_LE(gl_objects().bytes, before.bytes);
}

// Dark for a minute, in the whole scene or in the room that is seen, which may have been lit before. The
// light of the first frame is right: where it was lit once, what was known of surfaces and rays still is.
TEST_P(Hardships, ALampSwitchedOnAfterABlackMinuteIsRightAtOnce) {
    constexpr int kMinute = 1800;  // 30 frames a second
    struct Before {
        bool lit;
        float elsewhere;  // cd
    };
    for (const auto& [was_lit, elsewhere] : {Before{false, 60}, Before{true, 0}}) {
        const FrameScene lit = two_rooms(100, elsewhere);
        const Truth truth = truth_of(lit, kSize);
        const double usual = settled_error(lit, truth);

        Bench bench;
        bench.settings = settings();
        FrameScene scene = two_rooms(0, elsewhere);
        if (was_lit) {
            settled(bench, lit);
            hold_still(scene);
            scene.changes.lights = true;
        }
        const ImageF black = bench.frame(scene, kSize);
        EXPECT_LT(mean_of(black), 1e-4) << "lux: what comes through walls";
        hold_still(scene);
        for (int f = 1; f < kMinute; ++f) {
            bench.app.world().insert_resource(scene);
            bench.app.show();
            ++scene.frame;
        }
        scene.lights = lit.lights;
        scene.changes.lights = true;
        const Deviation first = against(bench.frame(scene, kSize), truth);
        std::printf("switched on, %g cd elsewhere, %s: relRMSE %.4f, flux %.4f; steady %.4f\n",
                    static_cast<double>(elsewhere), was_lit ? "lit before" : "never lit", first.rel_rmse,
                    first.mean, usual);
        EXPECT_LT(first.rel_rmse, was_lit ? 1.15 * usual : std::max(kFirst * usual, kAllowed));
        EXPECT_NEAR(first.mean, 1, 0.03);
        EXPECT_EQ(bad_values(bench), 0u);
    }
}

// In the dark the camera turns; another lamp goes on. Nothing of the light before is left, not even of
// endless bounces, and the view is the one that there is.
TEST_P(Hardships, AnotherViewAndLampAfterTheDark) {
    Bench bench;
    bench.settings = settings();
    bench.settings.edit<EmcSettings>().gather_endless = true;
    FrameScene scene = two_rooms(1000, 0);
    settled(bench, scene);
    hold_still(scene);
    scene.lights = two_rooms(0, 0).lights;
    scene.changes.lights = true;
    bench.frame(scene, kSize);
    hold_still(scene);
    look_from(scene, 2);
    bench.frame(scene, kSize);
    hold_still(scene);
    scene.lights[0] = point_light(vec3(3.4f, 0.6f, 2.6f), 10);
    scene.changes.lights = true;
    const ImageF after = bench.frame(scene, kSize);
    Bench fresh;
    fresh.settings = bench.settings;
    const double share = mean_of(after) / mean_of(fresh.frame(all_new(scene), kSize));
    std::printf("another view and lamp after the dark: %.4f of the light of a fresh start\n", share);
    EXPECT_NEAR(share, 1, 0.03);
}

TEST_P(Hardships, ACameraThatJumpsBetweenRoomsSeesNoOtherRoomsLight) {
    FrameScene scene = two_rooms(100, 20);
    Bench bench;
    bench.settings = settings();
    std::vector<Truth> truth;
    std::vector<double> usual;
    constexpr int kRooms = 2;  // the first view of each
    for (int view = 0; view < kRooms; ++view) {
        look_from(scene, view);
        truth.push_back(view == 0 ? truth_of_the_first_room() : truth_of(scene, kSize));
        usual.push_back(settled_error(scene, truth.back()));
    }
    double worst = 0;
    GlObjects before;
    for (int f = 0; f < 8 * kRooms; ++f) {
        const int view = f % kRooms;
        const auto v = static_cast<std::size_t>(view);
        look_from(scene, view);
        const Deviation there = against(bench.frame(scene, kSize), truth[v]);
        worst = std::max(worst, there.rel_rmse);
        EXPECT_LT(there.rel_rmse, std::max(kFirst * usual[v], kAllowed)) << "frame " << f;
        EXPECT_NEAR(there.mean, 1, 0.05) << "frame " << f;
        hold_still(scene);
        if (f == 2 * kRooms) {
            before = gl_objects();
        }
    }
    std::printf("camera jumps: relRMSE at most %.4f, settled %.4f to %.4f\n", worst,
                *std::ranges::min_element(usual), *std::ranges::max_element(usual));
    EXPECT_EQ(gl_objects(), before);
    EXPECT_EQ(bad_values(bench), 0u);
}

TEST_P(Hardships, AnotherSizeInEveryFrame) {
    FrameScene scene = two_rooms(100, 20);
    Bench bench;
    bench.settings = settings();
    const ivec2 sizes[] = {{64, 64}, {97, 61}, {1, 1}, {33, 128}, {128, 5}, {80, 60}};
    GlObjects before;
    for (int round = 0; round < 4; ++round) {
        for (const ivec2& size : sizes) {
            const ImageF image = bench.frame(scene, size);
            EXPECT_EQ(ivec2(image.width, image.height), size);
            expect_finite(image);
            hold_still(scene);
        }
        if (round == 1) {
            before = gl_objects();
        }
    }
    EXPECT_EQ(gl_objects(), before);
    const ImageF last = bench.frame(scene, kSize);
    const Truth& truth = truth_of_the_first_room();
    const Deviation there = against(last, truth);
    std::printf("another size in every frame: relRMSE %.4f, flux %.4f\n", there.rel_rmse, there.mean);
    EXPECT_NEAR(there.mean, 1, 0.03);
    EXPECT_EQ(bad_values(bench), 0u);
    Bench fresh;
    fresh.settings = settings();
    EXPECT_LT(there.rel_rmse, 1.1 * against(fresh.frame(all_new(scene), kSize), truth).rel_rmse);
}

// Whoever runs out of memory takes fewer or smaller maps: at any time, and gets them back.
TEST_P(Hardships, MapsAreGivenUpAndTakenBackWhileRunning) {
    FrameScene scene = two_rooms(100, 20);
    Bench bench;
    bench.settings = settings();
    const ImageF all = settled(bench, scene);
    const Truth& truth = truth_of_the_first_room();
    const auto begun = [&](const GiSettings& with) {
        Bench fresh;
        fresh.settings = with;
        FrameScene still = all_new(scene);
        ImageF image;
        for (int f = 0; f < 3; ++f) {
            image = fresh.frame(still, kSize);
            hold_still(still);
        }
        return against(image, truth).rel_rmse;
    };
    hold_still(scene);
    struct Share {
        int count, resolution, texels, candidates;
    };
    const auto take = [&](const Share& s) {
        GiSettings& now = bench.settings;
        now.edit<EmcSettings>().count = s.count;
        now.edit<EmcSettings>().resolution = s.resolution;
        now.edit<EmcSettings>().gather_texels = s.texels;
        now.edit<EmcSettings>().candidates = s.candidates;
    };
    // Programs that all techniques of a process share, or that a change needs first.
    const GiSettings whole = bench.settings;
    constexpr std::array kShares = {Share{2, 16, 16, 40}, Share{1, 16, 256, 1}, Share{32, 64, 32, 64},
                                    Share{8, 128, 64, 40}};
    for (const Share& s : kShares) {
        take(s);
        settled(bench, scene);
        begun(bench.settings);
    }
    bench.settings = whole;
    settled(bench, scene);
    const GlObjects before = gl_objects();
    for (const Share& s : kShares) {
        take(s);
        ImageF image;
        for (int f = 0; f < 3; ++f) {
            image = bench.frame(scene, kSize);
            expect_finite(image);
            EXPECT_LE(bench.technique().statistics(false).of<EmcStatistics>().k, s.count);
        }
        // What was remembered of other maps is no light in these.
        EXPECT_LT(against(image, truth).rel_rmse, 1.1 * begun(bench.settings)) << s.count;
        if (s.resolution == 16) {
            EXPECT_LT(gl_objects().bytes, before.bytes) << s.count;
        }
    }
    EXPECT_EQ(settled(bench, scene).pixels, all.pixels);
    EXPECT_EQ(gl_objects(), before);
    EXPECT_EQ(bad_values(bench), 0u);
}

// Once maps have been exchanged until a round changes nothing, a picture in which something has jumped away
// is one where it never was.
TEST_P(Hardships, WhatJumpsAwayLeavesNoGhostForLong) {
    FrameScene scene = two_rooms(100, 0);
    Bench bench;
    bench.settings = settings();
    settled(bench, scene);
    hold_still(scene);
    move_instance(scene, 2, glm::translate(mat4(1), vec3(10.2f, 0, 1)));
    const Truth truth = truth_of(scene, kSize);
    const double usual = settled_error(scene, truth);
    const Deviation first = against(bench.frame(scene, kSize), truth);
    hold_still(scene);
    ImageF image;
    for (int f = 1; f <= kSettled; ++f) {
        image = bench.frame(scene, kSize);
    }
    const Deviation last = against(image, truth);
    std::printf(
        "a block jumps away: relRMSE %.4f, flux %.4f; %d frames later %.4f, %.4f; a fresh start %.4f\n",
        first.rel_rmse, first.mean, kSettled, last.rel_rmse, last.mean, usual);
    EXPECT_LT(last.rel_rmse, 1.17 * usual);  // found: 1.158
    EXPECT_NEAR(last.mean, 1, 0.03);
}

// Lamp, camera and a figure that sways, all in every frame: light is right while they move, and once they
// stand no ghost stays for longer than is remembered.
TEST_P(Hardships, LampCameraAndFigureMoveAtOnce) {
    constexpr int kMoving = 30;
    FrameScene scene = two_rooms(100, 0);
    Bench bench;
    bench.settings = settings();
    const auto step = [&](int f) {
        const float t = static_cast<float>(f);
        scene.lights[0].position = vec3(0.6f + 0.02f * t, 2.2f, 1.5f);
        scene.changes.lights = true;
        support::look(scene, vec3(3.7f, 1.5f, 2.8f - 0.02f * t), vec3(1, 1, 1));
        scene.changes.camera = true;
        deform_instance(scene, 2, 1'000'000, [&](const vec3& p) {
            return p + p.y * vec3(0.3f * std::sin(0.1f * t), 0, 0.2f * std::sin(0.13f * t));
        });
    };
    step(0);
    settled(bench, scene);
    ImageF image;
    for (int f = 1; f <= kMoving; ++f) {
        hold_still(scene);
        step(f);
        image = bench.frame(scene, kSize);
        expect_finite(image);
    }
    const Truth truth = truth_of(scene, kSize);
    const double usual = settled_error(scene, truth);
    const Deviation moving = against(image, truth);
    hold_still(scene);
    for (int f = 0; f < kSettled; ++f) {
        image = bench.frame(scene, kSize);
    }
    const Deviation last = against(image, truth);
    std::printf("all moves: relRMSE %.4f, flux %.4f; %d frames later %.4f, %.4f; a fresh start %.4f\n",
                moving.rel_rmse, moving.mean, kSettled, last.rel_rmse, last.mean, usual);
    // Measured: gather 0.041, 0.10 where no ray is stale; splat 0.099.
    EXPECT_LT(moving.rel_rmse, GetParam() == EmcFinal::gather ? 0.044 : 0.11);
    EXPECT_NEAR(moving.mean, 1, 0.05);
    EXPECT_LT(last.rel_rmse, 1.15 * usual);
    EXPECT_NEAR(last.mean, 1, 0.03);
    EXPECT_EQ(bad_values(bench), 0u);
}

}  // namespace
}  // namespace lanthorn::gi::test
