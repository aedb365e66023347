// gi.gather.source = photons: photons on the lit maps as the source of their indirect light.
#include "gi_module/techniques/emc/lit_maps/lit_photons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace lit_photons_test {

constexpr ivec2 kSize(64);
constexpr int kAllFrames = LitPhotons::kFrames;

GiSettings photon_settings(int bounces = 2) {
    GiSettings settings;
    settings.edit<EmcSettings>().gather_source = GatherSource::photons;
    settings.edit<EmcSettings>().gather_points = 1;  // the grid is what it says
    settings.edit<EmcSettings>().gather_grid = 2;
    settings.bounces = bounces;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

class PhotonLitSphere : public ::testing::TestWithParam<std::tuple<int, float>> {};

TEST_P(PhotonLitSphere, IndirectIrradianceIsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    const double expected = support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), bounces);
    for (const int frames : {1, kAllFrames}) {
        Bench bench;
        bench.settings = photon_settings(bounces);
        const Deviation a =
            deviation_of(still_picture(bench, closed_sphere(albedo), frames, kSize), expected);
        std::printf("sphere lit by photons, albedo %g, %d bounces, %d frames: mean %.5f, relRMSE %.5f\n",
                    static_cast<double>(albedo), bounces, frames, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.005) << frames;
        EXPECT_LT(a.rel_rmse, 0.006) << frames;
    }
}

// All of it glows: pi L everywhere, of which albedo^b comes back after b reflections. Points on it are no
// measure of that light nearby, and photons bring it.
TEST_P(PhotonLitSphere, ThatGlowsAllOver) {
    const auto [bounces, albedo] = GetParam();
    constexpr float kNits = 10;
    const double expected =
        support::sphere_irradiance(static_cast<double>(kPi * kNits), 1, static_cast<double>(albedo), bounces);
    FrameScene scene = closed_sphere(albedo);
    scene.lights.clear();
    auto assets = std::make_shared<SceneAssets>(*scene.assets);
    assets->materials.edit(0, [](Material& m) { m.emissive = vec3(kNits); });
    scene.assets = assets;
    Bench bench;
    bench.settings = photon_settings(bounces);
    const Deviation a = deviation_of(still_picture(bench, scene, 1, kSize), expected);
    std::printf("glowing sphere, albedo %g, %d bounces: mean %.5f, relRMSE %.5f\n",
                static_cast<double>(albedo), bounces, a.mean, a.rel_rmse);
    EXPECT_NEAR(a.mean, 1, 0.01);
    EXPECT_LT(a.rel_rmse, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Bounces, PhotonLitSphere,
                         ::testing::Combine(::testing::Values(2, 4, 8), ::testing::Values(0.5f, 0.9f)));

// Kernels that hold enough photons are wide where these are few; which is taken must not hang on their noise.
TEST(LitPhotons, FewOfThemHaveNoBias) {
    const double expected = support::sphere_irradiance(kSphereLux, 1, 0.9, 2);
    double sum = 0;
    constexpr int kSeeds = 4;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        Bench bench;
        bench.settings = photon_settings();
        bench.settings.edit<EmcSettings>().gather_photons = 400;
        bench.settings.seed = seed;
        sum += deviation_of(still_picture(bench, closed_sphere(0.9f), 1, kSize), expected).mean / kSeeds;
    }
    std::printf("400 photons: mean %.5f\n", sum);
    EXPECT_NEAR(sum, 1, 0.01);
}

// Photons of four bounces, the last of which stands for all that follow.
TEST(LitPhotons, EndlessBouncesAreTheWholeSeries) {
    for (const float albedo : {0.5f, 0.8f}) {
        const double expected = support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), 200);
        Bench bench;
        bench.settings = photon_settings();
        bench.settings.edit<EmcSettings>().gather_endless = true;
        const Deviation a = deviation_of(still_picture(bench, closed_sphere(albedo), 1, kSize), expected);
        std::printf("endless, albedo %g: mean %.5f, relRMSE %.5f\n", static_cast<double>(albedo), a.mean,
                    a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.01);
        EXPECT_LT(a.rel_rmse, 0.01);
    }
}

TEST(LitPhotons, ShowWhatThePathTracerFinds) {
    struct Case {
        int bounces;
        bool endless;
        int bounces_of_path;
    };
    for (const Case& c : {Case{4, false, 4}, Case{2, true, 8}}) {
        const Truth truth = path_traced(room_with_block(), kSize, c.bounces_of_path, 512);
        for (const int frames : {1, kAllFrames}) {
            Bench bench;
            bench.settings = photon_settings(c.bounces);
            bench.settings.edit<EmcSettings>().gather_endless = c.endless;
            const Deviation a = against(still_picture(bench, room_with_block(), frames, kSize), truth);
            std::printf("room, %d bounces%s, %d frames: flux %.4f, relRMSE %.4f\n", c.bounces,
                        c.endless ? ", endless" : "", frames, a.mean, a.rel_rmse);
            EXPECT_NEAR(a.mean, 1, 0.02) << c.bounces << frames;
            EXPECT_LT(a.rel_rmse, frames == 1 ? 0.14 : 0.06) << c.bounces << frames;
        }
    }
}

// A wall of two sheets parts a lit room from a dark one. What photons bring to one side of it, no texel of
// the other counts.
TEST(LitPhotons, NoneComesThroughAWallWithoutThickness) {
    const auto seen_with_lamp_at = [](const vec3& lamp_at, GatherSource source) {
        const FrameScene scene = scene_of(
            {box(vec3(0), vec3(4, 2.6f, 3), true, 0), quad(vec3(2, 0, 0), vec3(0, 2.6f, 0), vec3(0, 0, 3), 0),
             quad(vec3(2, 0, 0), vec3(0, 0, 3), vec3(0, 2.6f, 0), 0)},
            {lambertian(vec3(0.6f))}, {point_light(lamp_at, 100)}, vec3(3.8f, 1.3f, 2.8f), vec3(2, 1, 1));
        Bench bench;
        bench.settings = photon_settings(4);
        bench.settings.edit<EmcSettings>().gather_source = source;
        return deviation_of(still_picture(bench, scene, 4, kSize), 1.0).mean;
    };
    const auto leaked = [&](GatherSource source) {
        return seen_with_lamp_at(vec3(0.6f, 2.2f, 1.5f), source) /
               seen_with_lamp_at(vec3(3.4f, 2.2f, 1.5f), source);
    };
    const double by_rays = leaked(GatherSource::rays), by_photons = leaked(GatherSource::photons);
    std::printf("behind a wall: %.5f of the light before it by photons, %.5f by rays\n", by_photons, by_rays);
    EXPECT_LT(by_photons, 0.001);
    EXPECT_LT(by_rays, 0.001);
}

// Through a slit a map sees a far wall beside the bright edges of the slit. Kernels are as wide as can be
// with so few photons, but keep to one surface.
TEST(LitPhotons, KernelsKeepToTheirSurface) {
    const FrameScene scene = scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0), vec3(1.8f, 2.6f, 1.35f), false, 0),
         box(vec3(1.6f, 0, 1.65f), vec3(1.8f, 2.6f, 3), false, 0)},
        {lambertian(vec3(0.6f))}, {point_light(vec3(0.6f, 2.2f, 0.4f), 100)}, vec3(2.0f, 1.3f, 0.2f),
        vec3(4, 1.2f, 2));
    const Truth truth = path_traced(scene, kSize, 2, 2048);
    double flux = 0;
    constexpr int kSeeds = 4;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        Bench bench;
        bench.settings = photon_settings();
        bench.settings.seed = seed;
        bench.settings.edit<EmcSettings>().gather_photons = 100;
        flux += against(still_picture(bench, scene, 4, kSize), truth).mean / kSeeds;
    }
    std::printf("behind a slit: flux %.4f\n", flux);
    EXPECT_NEAR(flux, 1, 0.05);
}

TEST(LitPhotons, TheSameSceneGivesTheSameBits) {
    Bench a;
    Bench b;
    a.settings = b.settings = photon_settings(3);
    a.settings.edit<EmcSettings>().gather_endless = b.settings.edit<EmcSettings>().gather_endless = true;
    EXPECT_EQ(still_picture(a, room_with_block(), 3, kSize).pixels,
              still_picture(b, room_with_block(), 3, kSize).pixels);
}

TEST(LitPhotons, AStillSceneRunsNothingOnceAllAreIn) {
    Bench bench;
    bench.settings = photon_settings();
    FrameScene scene = room_with_block();
    const ImageF last = still_picture(bench, scene, kAllFrames, kSize);
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("lit_photons"));
    EXPECT_EQ(bench.technique().statistics(true).of<PhotonStatistics>().emitted,
              static_cast<std::uint64_t>(bench.settings.of<EmcSettings>().gather_photons));
    hold_still(scene);
    EXPECT_EQ(bench.frame(scene, kSize, true).pixels, last.pixels);
    for (const char* pass : {"lit_photons", "lit_maps", "gather", "emission", "bounces", "lit_rays"}) {
        EXPECT_TRUE(std::ranges::none_of(bench.spans, [&](const auto& span) { return span.name == pass; }))
            << pass;
        EXPECT_FALSE(bench.technique().statistics(false).plan.on(pass)) << pass;
    }
}

// The mean of a lamp that goes out is dropped: what is left is the room where it never was.
TEST(LitPhotons, ALampThatGoesOutLeavesNothing) {
    Bench lit;
    lit.settings = photon_settings();
    lit.settings.edit<EmcSettings>().gather_guide = false;  // rays go where light was
    still_picture(lit, room_with_block(), kAllFrames, kSize);
    FrameScene dimmed = room_with_block(100, 0);
    hold_still(dimmed);
    dimmed.changes.lights = true;
    const ImageF after = still_picture(lit, dimmed, kAllFrames, kSize);
    Bench never;
    never.settings = lit.settings;
    EXPECT_EQ(after.pixels, still_picture(never, room_with_block(100, 0), kAllFrames, kSize).pixels);
}

// While a lamp moves the mean holds few frames, and lags little; at rest it forgets them.
TEST(LitPhotons, FollowALampThatMoves) {
    Bench bench;
    bench.settings = photon_settings();
    FrameScene scene = room_with_block(100, 0);
    still_picture(bench, scene, kAllFrames, kSize);
    hold_still(scene);
    scene.changes.lights = true;
    ImageF image;
    for (int f = 0; f < 30; ++f) {
        scene.lights.front().position.x += 0.05f;
        image = bench.frame(scene, kSize);
    }
    const Truth truth = path_traced(scene, kSize, 2, 512);
    const Deviation moving = against(image, truth);
    const Deviation after = against(still_picture(bench, scene, 1, kSize), truth);
    std::printf("a lamp moves: flux %.4f, relRMSE %.4f; at rest %.4f, %.4f\n", moving.mean, moving.rel_rmse,
                after.mean, after.rel_rmse);
    EXPECT_NEAR(moving.mean, 1, 0.02);
    EXPECT_LT(moving.rel_rmse, 0.09);
}

// A box that moves: texels that show something else begin anew, and areas follow.
TEST(LitPhotons, FollowABoxThatMoves) {
    Bench bench;
    bench.settings = photon_settings();
    FrameScene scene = room_with_block();
    still_picture(bench, scene, 4, kSize);
    ImageF image;
    for (int f = 1; f <= 12; ++f) {
        hold_still(scene);
        move_instance(scene, 1, glm::translate(mat4(1), vec3(0.05f * static_cast<float>(f), 0, 0)));
        image = bench.frame(scene, kSize);
    }
    const Deviation moving = against(image, path_traced(scene, kSize, 2, 512));
    std::printf("a box moves: flux %.4f, relRMSE %.4f\n", moving.mean, moving.rel_rmse);
    EXPECT_NEAR(moving.mean, 1, 0.03);  // measured: 1.028; by rays 1.021
    EXPECT_LT(moving.rel_rmse, 0.11);
}

// Small boxes beside one that moves: maps see mere chips of many, which one photon must not make bright.
TEST(LitPhotons, ChipsOfSurfacesDoNotShine) {
    std::vector<Mesh> blocks = {box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                                box(vec3(1.2f, 0.6f, 1.2f), vec3(1.8f, 1.2f, 1.8f), false, 1)};
    for (int i = 0; i < 60; ++i) {
        const vec3 at(0.2f + 0.6f * static_cast<float>(i % 6), 0.1f + 0.5f * static_cast<float>(i / 12),
                      0.3f + 0.45f * static_cast<float>(i % 5) + 0.1f * static_cast<float>(i % 7));
        blocks.push_back(box(at, at + vec3(0.08f, 0.06f, 0.1f), false, 0));
    }
    FrameScene scene =
        scene_of(blocks, {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                 {point_light(vec3(0.5f, 2.4f, 0.4f), 100)}, vec3(3.8f, 1.5f, 2.8f), vec3(1, 1, 1));
    const auto moved_by = [&](int frame) {
        hold_still(scene);
        move_instance(scene, 1, glm::translate(mat4(1), vec3(0.05f * static_cast<float>(frame), 0, 0)));
    };
    constexpr int kMoves = 12;
    std::vector<ImageF> last;
    for (const GatherSource source : {GatherSource::photons, GatherSource::rays}) {
        Bench bench;
        bench.settings = photon_settings();
        bench.settings.edit<EmcSettings>().gather_source = source;
        move_instance(scene, 1, mat4(1));
        still_picture(bench, scene, 2, kSize);
        for (int f = 1; f < kMoves; ++f) {
            moved_by(f);
            bench.frame(scene, kSize);
        }
        moved_by(kMoves);
        last.push_back(bench.frame(scene, kSize));
    }
    const Truth truth = path_traced(scene, kSize, 2, 512);
    const Deviation photons = against(last[0], truth), rays = against(last[1], truth);
    std::printf("among chips: flux %.4f, relRMSE %.4f; by rays %.4f, %.4f\n", photons.mean, photons.rel_rmse,
                rays.mean, rays.rel_rmse);
    EXPECT_NEAR(photons.mean, rays.mean, 0.02);
    EXPECT_LT(photons.rel_rmse, 1.1 * rays.rel_rmse);
}

// A panel that shines lies 7 cm deep in a wall, where no map sees it. None of its photons lands in the room
// before the wall, which has the light of a panel on it.
TEST(LitPhotons, WhatShinesInsideAWallStaysThere) {
    const auto flux = [](float x) {
        const std::vector<Mesh> house = {box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                                         box(vec3(3.85f, 0, 0), vec3(4, 2.6f, 3), false, 0),
                                         quad(vec3(x, 1, 1), vec3(0, 0, 1), vec3(0, 1, 0), 1)};
        const FrameScene scene = scene_of(house, {lambertian(vec3(0.5f)), support::lamp(vec3(800))}, {},
                                          vec3(0.3f, 1.5f, 0.3f), vec3(2, 0.8f, 2));
        Bench bench;
        bench.settings = photon_settings(3);
        const ImageF image = still_picture(bench, scene, kAllFrames, kSize);
        return std::reduce(image.pixels.begin(), image.pixels.end(), 0.0) /
               static_cast<double>(image.pixels.size());
    };
    const double on_it = flux(3.84f), in_it = flux(3.92f);
    std::printf("panel on a wall: %.3f lx, in it: %.5f\n", on_it, in_it);
    EXPECT_GT(on_it, 10);
    EXPECT_LT(in_it, 0.005 * on_it);  // without a look back from where they land: 0.41
}

}  // namespace lit_photons_test
}  // namespace lanthorn::gi::test
