// `coarse-path` in an App, against closed forms and the path tracer.
#include "lanthorn/coarse-path/coarse_path.h"
#include "gi_module/techniques/coarse-path/coarse_path_technique.h"

#include <gtest/gtest.h>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/block_room.h"
#include "tests/gpu/gi/settings_walk.h"
#include "tests/support/closed_forms.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(128);

// A Bench of this technique; tells the door of it first.
struct Coarse : Bench {
    Coarse() : Bench(add_coarse_path()) {}
    CoarseStatistics now() { return technique().statistics(false).of<CoarseStatistics>(); }
};

// relRMSE and flux against the path tracer, whose own noise is independent and taken off.
Deviation against_truth(const ImageF& image, const FrameScene& scene, int spp = 64) {
    reference::PathSettings settings;
    settings.spp = spp;
    settings.seed = 7;
    reference::PathTracer tracer(scene, {image.width, image.height}, settings, {.indirect = true});
    tracer.render({});
    const std::vector<float> truth = tracer.image(reference::PathAov::indirect);
    double squares = 0, sum = 0, wanted = 0, n = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const auto got = static_cast<double>(image.pixels[i]), want = static_cast<double>(truth[i]);
        EXPECT_TRUE(std::isfinite(got));
        if (want > 0) {
            squares += (got - want) * (got - want);
            sum += got;
            wanted += want;
            n += 1;
        }
    }
    const double noise = tracer.noise(reference::PathAov::indirect);
    const double error = std::sqrt(squares / n) / (wanted / n);
    return {sum / wanted, std::sqrt(std::max(0.0, error * error - noise * noise))};
}

class SphereByPaths : public ::testing::TestWithParam<std::tuple<int, float>> {};

TEST_P(SphereByPaths, IsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    Coarse bench;
    bench.settings.bounces = bounces;
    const Deviation a =
        deviation_of(bench.frame(closed_sphere(albedo), kSize),
                     support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), bounces));
    std::printf("coarse-path, closed sphere, albedo %g, %d bounces: mean %.4f, relRMSE %.4f\n",
                static_cast<double>(albedo), bounces, a.mean, a.rel_rmse);
    // Every path brings the same there: what is left is the sphere's facets.
    EXPECT_NEAR(a.mean, 1, 0.002);
    EXPECT_LT(a.rel_rmse, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Bounces, SphereByPaths,
                         ::testing::Combine(::testing::Values(1, 2, 4), ::testing::Values(0.5f, 0.9f)));

// E = pi L (rho + ... + rho^n) in a cavity that glows.
TEST(CoarsePath, AGlowingCavityIsTheGeometricSeries) {
    Material walls = lambertian(vec3(0.5f));
    walls.emissive = vec3(10);
    FrameScene scene = scene_of({inward_sphere(1, 4, 0)}, {walls}, {}, vec3(0.2f), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 1.4f;
    Coarse bench;
    bench.settings.bounces = 3;
    const Deviation a =
        deviation_of(bench.frame(scene, kSize), support::sphere_irradiance(support::kPiD * 10, 1, 0.5, 3));
    EXPECT_NEAR(a.mean, 1, 0.01);
    EXPECT_LT(a.rel_rmse, 0.05);
}

TEST(CoarsePath, CornellConvergesToThePathTracer) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/cornell.glb")));
    Transforms().update(world);
    FrameScene scene = Extractor().extract(world, find_by_name(world, "camera"));
    Coarse bench;
    bench.settings.edit<CoarseSettings>().grid = Spacing::two;  // as fine for 128 pixels as 4 is for 256
    const Deviation first = against_truth(bench.frame(scene, kSize), scene, 256);
    hold_still(scene);
    ImageF image;
    for (int i = 0; i < 40; ++i) {
        image = bench.frame(scene, kSize);
    }
    const Deviation last = against_truth(image, scene, 256);
    std::printf("coarse-path, cornell: relRMSE %.4f, flux %.4f; after 32 frames %.4f, %.4f\n", first.rel_rmse,
                first.mean, last.rel_rmse, last.mean);
    EXPECT_NEAR(last.mean, 1, 0.02);
    EXPECT_LT(last.rel_rmse, 0.6 * first.rel_rmse);
}

TEST(CoarsePath, AStillPictureEndsItsPaths) {
    FrameScene scene = room_with_block(2);
    Coarse bench;
    bench.settings.edit<CoarseSettings>().still_history = 4;
    bench.settings.edit<CoarseSettings>().history = 4;
    bench.frame(scene, kSize);
    EXPECT_GT(bench.now().rays, 0u);
    hold_still(scene);
    for (int i = 0; i < 3; ++i) {
        bench.frame(scene, kSize);
        EXPECT_GT(bench.now().rays, 0u);
    }
    const auto last = bench.frame(scene, kSize);
    EXPECT_EQ(bench.now().rays, 0u);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("paths"));
    EXPECT_EQ(bench.frame(scene, kSize).pixels, last.pixels);
}

// A seed changed under a still camera read estimates that were gone.
TEST(CoarsePath, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_coarse_path();
    const auto altered = walk_settings(
        room_with_block(2),
        {"gi.technique=coarse-path", "gi.coarse-path.history=3", "gi.coarse-path.still_history=4"}, 6);
    for (const char* name :
         {"gi.technique", "gi.bounces", "gi.seed", "gi.coarse-path.grid", "gi.coarse-path.samples",
          "gi.coarse-path.still_history", "gi.coarse-path.filter", "gi.coarse-path.sigma"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    EXPECT_TRUE(std::ranges::find(altered, "gi.coarse-path.threads") == altered.end());
}

TEST(CoarsePath, OneThreadAndTwoGiveTheSameBits) {
    FrameScene scene = room_with_block(2);
    Coarse one, two;
    one.settings.edit<CoarseSettings>().threads = 1;
    two.settings.edit<CoarseSettings>().threads = 2;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(one.frame(scene, kSize).pixels, two.frame(scene, kSize).pixels) << i;
        move_block(scene, 2 + 0.05f * static_cast<float>(i));
        scene.lights[0].position.x += 0.02f;
        scene.changes.lights = true;
    }
}

// Old light goes as alpha = 1 / history says, to less than 2 % of it after 30 frames of 1/8.
TEST(CoarsePath, FollowsALampThatMoves) {
    FrameScene scene = room_with_block(2);
    Coarse bench;
    bench.frame(scene, kSize);
    for (int i = 0; i < 30; ++i) {
        move_lamp(scene, vec3(3.4f, 2.2f, 1.5f));
        bench.frame(scene, kSize);
    }
    const auto followed = bench.frame(scene, kSize);
    const Deviation a = against_truth(followed, scene);
    std::printf("coarse-path, moved lamp: relRMSE %.4f, flux %.4f\n", a.rel_rmse, a.mean);
    EXPECT_NEAR(a.mean, 1, 0.03);
    EXPECT_LT(a.rel_rmse, 0.15);
}

TEST(CoarsePath, FollowsABoxThatMoves) {
    FrameScene scene = room_with_block(1.2f);
    Coarse bench;
    bench.frame(scene, kSize);
    for (int i = 0; i < 30; ++i) {
        move_block(scene, 1.2f + 0.05f * static_cast<float>(i + 1));
        bench.frame(scene, kSize);
    }
    EXPECT_EQ(bench.now().builds, 1u);
    const CoarseStatistics now = bench.now();
    EXPECT_LT(now.new_points, now.points / 10);  // what came out from behind it
    move_block(scene, 2.7f);
    const Deviation a = against_truth(bench.frame(scene, kSize), scene);
    std::printf("coarse-path, moving box: relRMSE %.4f, flux %.4f, %llu of %llu points new\n", a.rel_rmse,
                a.mean, static_cast<unsigned long long>(now.new_points),
                static_cast<unsigned long long>(now.points));
    EXPECT_NEAR(a.mean, 1, 0.03);
    EXPECT_LT(a.rel_rmse, 0.2);
}

// To another room: nothing of the old picture is kept.
TEST(CoarsePath, ACutDropsTheHistory) {
    FrameScene scene = room_with_block(2);
    Coarse bench;
    for (int i = 0; i < 8; ++i) {
        bench.frame(scene, kSize);
        hold_still(scene);
    }
    EXPECT_EQ(bench.now().new_points, 0u);
    EXPECT_GT(bench.now().history, 10);
    support::look(scene, vec3(0.3f, 1.5f, 2.8f), vec3(1.2f, 1, 1));  // the block's other side
    scene.changes.camera = true;
    bench.frame(scene, kSize);
    EXPECT_GT(2 * bench.now().new_points, bench.now().points);
    FrameScene turned = scene;
    support::look(turned, vec3(3.7f, 1.5f, 2.8f), vec3(3.8f, 1.5f, 3));  // into the corner
    hold_still(turned);
    turned.changes.camera = true;
    bench.frame(turned, kSize);
    EXPECT_EQ(bench.now().new_points, bench.now().points);
}

TEST(CoarsePath, NothingIsTracedWithoutLight) {
    FrameScene scene = room_with_block(2);
    scene.lights.clear();
    Coarse bench;
    for (const float v : bench.frame(scene, kSize).pixels) {
        EXPECT_EQ(v, 0);
    }
    EXPECT_EQ(bench.now().rays, 0u);
    // And when light comes, all is there.
    FrameScene lit = room_with_block(2);
    hold_still(lit);
    lit.changes.lights = true;
    const Deviation a = against_truth(bench.frame(lit, kSize), lit);
    EXPECT_NEAR(a.mean, 1, 0.1);
}

}  // namespace
}  // namespace lanthorn::gi::test
