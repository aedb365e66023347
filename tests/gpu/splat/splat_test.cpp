// `splat` in an App, against closed forms and the path tracer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/block_room.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/settings_walk.h"
#include "tests/gpu/splat/splat_bench.h"
#include "tests/support/closed_forms.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

class SphereBySplats : public ::testing::TestWithParam<std::tuple<int, float, PhotonKernel>> {};

TEST_P(SphereBySplats, IsTheGeometricSeries) {
    const auto [bounces, albedo, kernel] = GetParam();
    Splat bench(400'000);
    bench.settings.bounces = bounces;
    bench.own().kernel = kernel;
    const Deviation a =
        deviation_of(bench.frame(closed_sphere(albedo), kSize),
                     support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), bounces));
    // As many photons as are averaged: the noise of pi C^2 of them, bounces of one walk being of a kind.
    EXPECT_NEAR(a.mean, 1, 0.01);
    EXPECT_LT(a.rel_rmse, 0.06);
    EXPECT_EQ(bench.now().surfaces, 1u);
}

INSTANTIATE_TEST_SUITE_P(Kernels, SphereBySplats,
                         ::testing::Combine(::testing::Values(1, 3), ::testing::Values(0.5f, 0.9f),
                                            ::testing::Values(PhotonKernel::constant,
                                                              PhotonKernel::epanechnikov)));

FrameScene cornell() {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/cornell.glb")));
    Transforms().update(world);
    return Extractor().extract(world, find_by_name(world, "camera"));
}

TEST(PhotonSplat, CornellIsThePathTracersToItsBlur) {
    const FrameScene scene = cornell();
    Splat bench(400'000);
    bench.own().bandwidth = 12;
    const Deviation a = against(bench.frame(scene, kSize), path_traced(scene, kSize, 2, 256));
    std::printf("splat, cornell, 400 000 walks: relRMSE %.4f, flux %.4f\n", a.rel_rmse, a.mean);
    EXPECT_NEAR(a.mean, 1, 0.02);
    EXPECT_LT(a.rel_rmse, 0.15);
    // Without the correction the room darkens along all its edges.
    bench.own().boundaries = false;
    const Deviation dark = against(bench.frame(scene, kSize), path_traced(scene, kSize, 2, 256));
    std::printf("  without the correction of boundaries: relRMSE %.4f, flux %.4f\n", dark.rel_rmse,
                dark.mean);
    EXPECT_LT(dark.mean, 0.95);
    EXPECT_GT(dark.rel_rmse, 1.3 * a.rel_rmse);
}

TEST(PhotonSplat, APictureGetsBetterWhileNothingChangesAndThenRests) {
    FrameScene scene = room_with_block(2);
    Splat bench(4000);
    bench.own().photons = 256'000;
    const Deviation first = against(bench.frame(scene, kSize), path_traced(scene, kSize, 2, 64));
    hold_still(scene);
    for (int i = 0; i < 7; ++i) {
        bench.frame(scene, kSize);
    }
    const SplatStatistics done = bench.now();
    EXPECT_EQ(done.walks, 256'000u);
    const ImageF image = bench.frame(scene, kSize);
    const Deviation last = against(image, path_traced(scene, kSize, 2, 64));
    std::printf("splat, room: relRMSE %.4f, after 256 000 walks %.4f\n", first.rel_rmse, last.rel_rmse);
    EXPECT_LT(last.rel_rmse, 0.6 * first.rel_rmse);
    // Nothing changes: no work.
    EXPECT_EQ(bench.now().splatted, 0u);
    EXPECT_EQ(bench.now().rays, done.rays);
    for (const char* pass : {"surfaces", "photons", "item_buffer", "splats"}) {
        EXPECT_FALSE(bench.technique().statistics(false).plan.on(pass)) << pass;
    }
    EXPECT_EQ(bench.frame(scene, kSize).pixels, image.pixels);
}

TEST(PhotonSplat, AnotherViewIsSplattedFromTheSamePhotons) {
    FrameScene scene = room_with_block(2);
    Splat bench;
    bench.frame(scene, kSize);
    const std::uint64_t rays = bench.now().rays;
    hold_still(scene);
    support::look(scene, vec3(0.3f, 1.5f, 2.8f), vec3(3, 1, 1));
    scene.changes.camera = true;
    const ImageF image = bench.frame(scene, kSize);
    EXPECT_EQ(bench.now().rays, rays);
    EXPECT_GT(bench.now().splatted, 0u);
    FrameScene anew = scene;
    anew.changes = SceneChanges();
    anew.changes.moved = {0, 1};
    Splat fresh;
    EXPECT_EQ(fresh.frame(anew, kSize).pixels, image.pixels);
}

TEST(PhotonSplat, FollowsLampsAndThingsThatMove) {
    FrameScene scene = room_with_block(1.2f);
    Splat bench;
    bench.frame(scene, kSize);
    hold_still(scene);
    move_instance(scene, 1, glm::translate(mat4(1), vec3(2.5f, 0, 1.2f)));
    scene.changes.geometry = true;
    bench.frame(scene, kSize);
    hold_still(scene);
    scene.lights[0].position = vec3(3.4f, 2.2f, 1.5f);
    scene.changes.lights = true;
    const ImageF image = bench.frame(scene, kSize);
    EXPECT_EQ(bench.now().builds, 1u);  // refitted
    const Deviation a = against(image, path_traced(scene, kSize, 2, 64));
    EXPECT_NEAR(a.mean, 1, 0.03);
    EXPECT_LT(a.rel_rmse, 0.2);
}

TEST(PhotonSplat, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_splat();
    const auto altered = walk_settings(
        room_with_block(2),
        {"gi.technique=splat", "gi.photons=4000", "gi.splat.photons=8000", "gi.splat.batch=4000"}, 5);
    for (const char* name : {"gi.technique", "gi.bounces", "gi.seed", "gi.photons", "gi.splat.photons",
                             "gi.splat.bandwidth", "gi.splat.kernel", "gi.splat.boundaries"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    EXPECT_TRUE(std::ranges::find(altered, "gi.splat.threads") == altered.end());
}

TEST(PhotonSplat, OneThreadAndTwoGiveTheSameBits) {
    const FrameScene scene = room_with_block(2);
    Splat one(20'000), two(20'000);
    one.own().threads = 1;
    two.own().threads = 2;
    EXPECT_EQ(one.frame(scene, kSize).pixels, two.frame(scene, kSize).pixels);
}

TEST(PhotonSplat, PhotonsOnDiskMakeTheSamePicture) {
    const FrameScene scene = closed_sphere(0.9f);
    Splat kept(900'000), streamed(900'000);
    kept.own().bandwidth = streamed.own().bandwidth = 8;
    streamed.own().memory = 32;
    const ImageF image = kept.frame(scene, kSize);
    EXPECT_EQ(streamed.frame(scene, kSize).pixels, image.pixels);
    EXPECT_EQ(kept.now().on_disk, 0u);
    EXPECT_GT(streamed.now().on_disk, 10'000'000u);
    EXPECT_LT(streamed.now().memory, std::uint64_t{32} << 20);
}

// The picture is what the photons before made of it, and it says so.
TEST(PhotonSplat, AFullDiskKeepsThePhotonsThatFitted) {
    FrameScene scene = closed_sphere(0.9f);
    Splat bench(400'000);
    bench.own().memory = 32;
    bench.own().photons = 3'000'000;
    bench.own().batch = 800'000;
    bench.own().bandwidth = 8;
    bench.frame(scene, kSize);
    hold_still(scene);
    const support::FileSizeLimit limit(1'000'000);
    ImageF image;
    for (int i = 0; i < 3; ++i) {
        image = bench.frame(scene, kSize);
    }
    const SplatStatistics now = bench.now();
    EXPECT_NE(now.error.find("temporary file"), std::string::npos) << now.error;
    EXPECT_GE(now.walks, 400'000u);
    EXPECT_LT(now.walks, 3'000'000u);
    EXPECT_NEAR(
        deviation_of(image, support::sphere_irradiance(kSphereLux, 1, 0.9, bench.settings.bounces)).mean, 1,
        0.01);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("photons"));
}

// So wide that every photon lies within reach of every pixel: as many entries as there can be, more than are
// kept at once, and still each photon counts once.
TEST(PhotonSplat, PhotonsThatReachAllOfThePictureAreSplattedInPieces) {
    constexpr ivec2 kWide(192);  // 576 tiles
    Splat bench(200'000);
    bench.own().bandwidth = 1000;
    const Deviation a = deviation_of(bench.frame(closed_sphere(0.5f), kWide),
                                     support::sphere_irradiance(kSphereLux, 1, 0.5, bench.settings.bounces));
    const std::size_t blocks = bench.now().photons / PhotonBlock::kMost;
    EXPECT_GT(blocks * 576, 2 * PhotonSplats::kMostEntries);
    EXPECT_NEAR(a.mean, 1, 0.01);
    EXPECT_LT(a.rel_rmse, 0.01);  // all of them averaged everywhere
}

// Their photons lie in the same runs; each keeps its own power.
TEST(PhotonSplat, LampsOfManyColoursAreRight) {
    FrameScene scene = room_with_block(2);
    scene.lights.clear();
    for (std::uint32_t i = 0; i < 12; ++i) {
        const float x = static_cast<float>(i) / 11;
        scene.lights.push_back(point_light(vec3(0.6f + 2.8f * x, 2.2f, 1.5f), 5 + 10 * x));
        scene.lights.back().light.colour = vec3(1 - x, 0.1f + 0.5f * x, x * x);
        scene.lights.back().id = 1000 + i;
    }
    Splat bench(200'000);
    const Deviation a = against(bench.frame(scene, kSize), path_traced(scene, kSize, 2, 256));
    EXPECT_NEAR(a.mean, 1, 0.02);
    EXPECT_LT(a.rel_rmse, 0.15);
}

void expect_black(const ImageF& image) {
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return v == 0; }));
}

TEST(PhotonSplat, NoPhotonsAndNoLightAreBlack) {
    Splat none(0);
    expect_black(none.frame(room_with_block(2), kSize));
    FrameScene dark = room_with_block(2);
    dark.lights[0].light.intensity = 0;
    Splat bench;
    expect_black(bench.frame(dark, kSize));
    dark.lights.clear();
    dark.changes.lights = true;
    expect_black(bench.frame(dark, kSize));
    FrameScene lit = room_with_block(2);  // and light again
    EXPECT_NEAR(against(bench.frame(lit, kSize), path_traced(lit, kSize, 2, 64)).mean, 1, 0.03);
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
}

// One photon, and all photons on one point: a beam so narrow that there is but one.
TEST(PhotonSplat, FewPhotonsAndPhotonsOnOnePointAreFinite) {
    Splat one(1);
    const ImageF single = one.frame(room_with_block(2), kSize);
    EXPECT_TRUE(std::ranges::all_of(single.pixels, [](float v) { return std::isfinite(v) && v >= 0; }));
    FrameScene scene = room_with_block(2);
    scene.lights = {spot_light(vec3(3, 1, 1.5f), vec3(-1, -1e-3f, 0), 1e9f, 1e-3f)};
    scene.lights[0].id = 1000;
    Splat bench(50'000);
    const ImageF image = bench.frame(scene, kSize);
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return std::isfinite(v) && v >= 0; }));
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
    EXPECT_TRUE(std::ranges::any_of(image.pixels, [](float v) { return v > 0; }));
}

// A wall of one vertex, and a scene of that alone.
TEST(PhotonSplat, AMeshOfOneVertexIsNoTrouble) {
    Mesh point = quad(vec3(1), vec3(1, 0, 0), vec3(0, 1, 0), 0);
    point.vertices.resize(1);
    point.indices = {0, 0, 0};
    point.bounds = {vec3(1), vec3(1)};
    Splat bench(1000);
    expect_black(bench.frame(
        scene_of({point}, {lambertian(vec3(0.5f))}, {point_light(vec3(0), 1)}, vec3(0, 0, 3), vec3(0)),
        kSize));
}

// Light that a mirror throws onto a floor comes from the lamp's image behind it, where that is seen through
// the mirror's outline: a pattern with sharp edges, which smaller bandwidths find.
TEST(PhotonSplat, CausticsAreTheLampsImageAndSharperWithSmallerBandwidths) {
    Material mirror = lambertian(vec3(1));
    mirror.metallic = 1;
    mirror.roughness = 0;
    FrameScene scene = scene_of({quad(vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), 0),
                                 quad(vec3(-0.9f, 0.2f, -0.3f), vec3(0, 0.5f, 0), vec3(0, 0, 0.6f), 1)},
                                {lambertian(vec3(0.05f)), mirror}, {point_light(vec3(0.6f, 1, 0), 100)},
                                vec3(0), vec3(0, 0, 1));
    look_closely(scene, vec3(0, 3, 0), vec3(0), 0.95f);  // from above; the mirror is seen edge on
    const dvec3 image(-2.4, 1, 0);
    std::vector<double> truth;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const dvec3 p(-0.95 * (2 * (x + 0.5) / kSize.x - 1), 0, 0.95 * (1 - 2 * (y + 0.5) / kSize.y));
            const dvec3 way = p - image;
            const dvec3 at = image + way * (1.5 / way.x);
            const bool seen = p.x > -0.9 && at.y > 0.2 && at.y < 0.7 && std::abs(at.z) < 0.3;
            truth.push_back(seen ? 100 * -way.y / std::pow(glm::length(way), 3) : 0);
        }
    }
    const auto error = [&](const ImageF& got) {
        double squares = 0, sum = 0, wanted = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const auto value = static_cast<double>(got.pixels[3 * i]);
            squares += std::pow(value - truth[i], 2);
            sum += value;
            wanted += truth[i];
        }
        return Deviation{sum / wanted, std::sqrt(squares * static_cast<double>(truth.size())) / wanted};
    };
    Splat bench(2'000'000);
    bench.own().caustic_bandwidth = 16;
    bench.own().adaptive = SplatAdaptive::none;
    const Deviation wide = error(bench.frame(scene, kSize));
    EXPECT_EQ(bench.now().rounds, 2);
    EXPECT_GT(bench.now().caustic_photons, 1000u);
    bench.own().adaptive = SplatAdaptive::caustics;
    bench.own().levels = 8;
    const Deviation adapted = error(bench.frame(scene, kSize));
    std::printf("splat, caustic: relRMSE %.4f, flux %.4f; adaptive %.4f, %.4f\n", wide.rel_rmse, wide.mean,
                adapted.rel_rmse, adapted.mean);
    EXPECT_GT(bench.now().rounds, 2);
    EXPECT_NEAR(wide.mean, 1, 0.06);
    EXPECT_NEAR(adapted.mean, 1, 0.06);
    EXPECT_LT(adapted.rel_rmse, 0.8 * wide.rel_rmse);
}

}  // namespace
}  // namespace lanthorn::gi::test
