// `vertex-map` in an App, against closed forms and the path tracer.
#include <gtest/gtest.h>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/block_room.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/settings_walk.h"
#include "tests/gpu/vertex-map/vertex_map_bench.h"
#include "tests/support/closed_forms.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

class SphereByPhotons : public ::testing::TestWithParam<std::tuple<int, float>> {};

// The photons of each bounce are spread evenly over it: an estimate of 400 is off by 1 / sqrt(300) or so.
TEST_P(SphereByPhotons, IsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    VertexMap bench;
    bench.settings.bounces = bounces;
    bench.own().total = 60'000;
    bench.own().max_level = 5;
    bench.own().nearest = 400;
    FrameScene scene = closed_sphere(albedo);
    const Deviation a =
        deviation_of(bench.settled(scene),
                     support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), bounces));
    std::printf("vertex-map, closed sphere, albedo %g, %d bounces: mean %.4f, relRMSE %.4f\n",
                static_cast<double>(albedo), bounces, a.mean, a.rel_rmse);
    EXPECT_NEAR(a.mean, 1, 0.02);
    EXPECT_LT(a.rel_rmse, 0.08);
}

INSTANTIATE_TEST_SUITE_P(Bounces, SphereByPhotons,
                         ::testing::Combine(::testing::Values(1, 2, 4), ::testing::Values(0.5f, 0.9f)));

TEST(VertexMap, CornellIsThePathTracers) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/cornell.glb")));
    Transforms().update(world);
    FrameScene scene = Extractor().extract(world, find_by_name(world, "camera"));
    VertexMap bench;
    const Truth truth = path_traced(scene, kSize, 2, 256);
    const Deviation few = against(bench.settled(scene), truth);
    bench.own().total = 200'000;
    bench.own().per_frame = 20'000;
    bench.own().nearest = 500;
    bench.own().density = 2;
    const Deviation many = against(bench.settled(scene), truth);
    std::printf("vertex-map, cornell: relRMSE %.4f, flux %.4f; 200 k photons %.4f, %.4f\n", few.rel_rmse,
                few.mean, many.rel_rmse, many.mean);
    EXPECT_NEAR(few.mean, 1, 0.04);
    EXPECT_LT(few.rel_rmse, 0.25);
    EXPECT_NEAR(many.mean, 1, 0.03);
    EXPECT_LT(many.rel_rmse, 0.8 * few.rel_rmse);
}

TEST(VertexMap, AStillSceneCostsNothingOnceItIsDone) {
    FrameScene scene = room_with_block(2);
    VertexMap bench;
    const ImageF done = bench.settled(scene);
    EXPECT_EQ(bench.frame(scene, kSize).pixels, done.pixels);
    const GiStatistics statistics = bench.technique().statistics(false);
    for (const PlanEntry& entry : statistics.plan.entries) {
        EXPECT_FALSE(entry.on) << entry.pass;
    }
    EXPECT_EQ(statistics.of<VertexMapStatistics>().rays, 0u);
}

// All photons in the first frame; then, after a change, per_frame in each until all are of the scene as it
// is.
TEST(VertexMap, ReplacesTheOldestPhotonsFrameByFrame) {
    FrameScene scene = room_with_block(2);
    VertexMap bench;
    bench.own().total = 1000;
    bench.own().per_frame = 300;
    bench.frame(scene, kSize);
    EXPECT_EQ(bench.now().photons, 1000u);
    EXPECT_EQ(bench.now().left, 0u);
    move_lamp(scene, vec3(3.4f, 2.2f, 1.5f));
    for (const std::uint64_t left : {700u, 400u, 100u, 0u}) {
        bench.frame(scene, kSize);
        EXPECT_EQ(bench.now().left, left);
        hold_still(scene);
    }
    bench.frame(scene, kSize);
    EXPECT_EQ(bench.now().photons, 0u);
}

// And then has what a scene that was always so has.
TEST(VertexMap, ALampThatHasMovedLeavesNoOldLight) {
    FrameScene scene = room_with_block(2);
    VertexMap bench;
    bench.own().density = 0;
    bench.settled(scene);
    move_lamp(scene, vec3(3.4f, 2.2f, 1.5f));
    const ImageF moved = bench.settled(scene);
    FrameScene there = room_with_block(2);
    there.lights[0].position = vec3(3.4f, 2.2f, 1.5f);
    VertexMap fresh;
    fresh.own().density = 0;
    EXPECT_EQ(moved.pixels, fresh.settled(there).pixels);
}

TEST(VertexMap, ABoxThatHasMovedLeavesNoOldLight) {
    FrameScene scene = room_with_block(1.2f);
    VertexMap bench;
    bench.settled(scene);
    for (int i = 1; i <= 10; ++i) {
        move_block(scene, 1.2f + 0.1f * static_cast<float>(i));
        bench.frame(scene, kSize);
    }
    EXPECT_EQ(bench.now().builds, 1u);
    const ImageF moved = bench.settled(scene);
    const Deviation a = against(moved, path_traced(scene, kSize, 2, 64));
    std::printf("vertex-map, moved box: relRMSE %.4f, flux %.4f\n", a.rel_rmse, a.mean);
    EXPECT_NEAR(a.mean, 1, 0.05);
    EXPECT_LT(a.rel_rmse, 0.25);
}

TEST(VertexMap, BothTreesGiveTheSamePicture) {
    FrameScene scene = room_with_block(2);
    VertexMap kept, rebuilt;
    rebuilt.own().tree = TreeKind::rebuilt;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(kept.frame(scene, kSize).pixels, rebuilt.frame(scene, kSize).pixels) << i;
        move_lamp(scene, vec3(0.6f + 0.3f * static_cast<float>(i), 2.2f, 1.5f));
    }
}

TEST(VertexMap, OneThreadAndTwoGiveTheSameBits) {
    FrameScene scene = room_with_block(2);
    VertexMap one, two;
    one.own().threads = 1;
    two.own().threads = 2;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(one.frame(scene, kSize).pixels, two.frame(scene, kSize).pixels) << i;
        move_block(scene, 2 + 0.05f * static_cast<float>(i));
    }
}

// What is not seen gets no estimate, and nothing of it is missed.
TEST(VertexMap, SkippedVerticesAreNotMissed) {
    FrameScene scene = room_with_block(2);
    VertexMap all, facing, hidden;
    all.own().skip = SkippedVertices::none;
    facing.own().skip = SkippedVertices::back_faces;
    for (VertexMap* bench : {&all, &facing, &hidden}) {
        bench->own().density = 0;
    }
    const ImageF picture = all.frame(scene, kSize);
    EXPECT_EQ(facing.frame(scene, kSize).pixels, picture.pixels);
    EXPECT_EQ(hidden.frame(scene, kSize).pixels, picture.pixels);
    EXPECT_EQ(all.now().estimates, all.now().corners);
    EXPECT_LT(facing.now().estimates, all.now().estimates);
    EXPECT_LT(hidden.now().estimates, facing.now().estimates);
    // A camera that turns finds the rest.
    support::look(scene, vec3(0.3f, 1.5f, 0.2f), vec3(3, 1, 2));
    hold_still(scene);
    scene.changes.camera = true;
    EXPECT_EQ(hidden.frame(scene, kSize).pixels, all.frame(scene, kSize).pixels);
    EXPECT_GT(hidden.now().estimates, 0u);
    EXPECT_EQ(hidden.now().rays, 0u);
}

// Both faces of a sheet, of which only one is lit.
TEST(VertexMap, ASheetIsLitOnTheSideThatLightComesTo) {
    Material sheet = lambertian(vec3(0.5f));
    sheet.double_sided = true;
    FrameScene scene = scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), quad(vec3(0, 0, 1), vec3(4, 0, 0), vec3(0, 2.6f, 0), 1)},
        {lambertian(vec3(0.6f)), sheet}, {point_light(vec3(2, 1.3f, 2), 100)}, vec3(2, 1.3f, 2.8f),
        vec3(2, 1.3f, 1));
    VertexMap bench;
    const Deviation lit = against(bench.settled(scene), path_traced(scene, kSize, 2, 64));
    EXPECT_NEAR(lit.mean, 1, 0.05);
    support::look(scene, vec3(2, 1.3f, 0.2f), vec3(2, 1.3f, 1));
    scene.changes.camera = true;
    for (const float v : bench.settled(scene).pixels) {
        ASSERT_EQ(v, 0);
    }
}

TEST(VertexMap, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_vertex_map();
    const auto altered = walk_settings(room_with_block(2),
                                       {"gi.technique=vertex-map", "gi.vertex-map.total=2000",
                                        "gi.vertex-map.per_frame=500", "gi.vertex-map.max_level=4"},
                                       10);
    for (const char* name :
         {"gi.technique", "gi.bounces", "gi.seed", "gi.vertex-map.total", "gi.vertex-map.max_level",
          "gi.vertex-map.direct", "gi.vertex-map.nearest", "gi.vertex-map.distance", "gi.vertex-map.kernel",
          "gi.vertex-map.surface_area", "gi.vertex-map.any_surface", "gi.vertex-map.edge"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    for (const char* name :
         {"gi.vertex-map.threads", "gi.vertex-map.tree", "gi.vertex-map.skip", "gi.vertex-map.corners"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) == altered.end()) << name;
    }
}

struct Extreme {
    const char* name;
    int total, per_frame, nearest;
};

class ByExtreme : public ::testing::TestWithParam<Extreme> {};

TEST_P(ByExtreme, IsFinite) {
    FrameScene scene = room_with_block(2);
    VertexMap bench;
    bench.own().total = GetParam().total;
    bench.own().per_frame = GetParam().per_frame;
    bench.own().nearest = GetParam().nearest;
    for (int i = 0; i < 3; ++i) {
        for (const float v : bench.frame(scene, kSize).pixels) {
            ASSERT_TRUE(std::isfinite(v) && v >= 0);
        }
        move_lamp(scene, vec3(1 + static_cast<float>(i), 2, 1));
    }
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
}

INSTANTIATE_TEST_SUITE_P(Ends, ByExtreme,
                         ::testing::Values(Extreme{"one photon", 1, 1, 2},
                                           Extreme{"more a frame than kept", 10, 1000, 2},
                                           Extreme{"more wanted than there are", 100, 7, 10'000}));

TEST(VertexMap, NothingIsShotWithoutLight) {
    FrameScene scene = room_with_block(2);
    scene.lights[0].light.intensity = 0;
    VertexMap bench;
    for (const float v : bench.frame(scene, kSize).pixels) {
        EXPECT_EQ(v, 0);
    }
    EXPECT_EQ(bench.now().rays, 0u);
    // And when light comes, all is there.
    FrameScene lit = room_with_block(2);
    hold_still(lit);
    lit.changes.lights = true;
    const Deviation a = against(bench.settled(lit), path_traced(lit, kSize, 2, 64));
    EXPECT_NEAR(a.mean, 1, 0.05);
}

// A mesh of one vertex, thrice: no area, no light on it, and none lost elsewhere.
TEST(VertexMap, AMeshOfOnePointIsNoHarm) {
    const FrameScene room = room_with_block(2);
    Mesh point = quad(vec3(2), vec3(1, 0, 0), vec3(0, 1, 0), 0);
    point.vertices.resize(1);
    point.indices = {0, 0, 0};
    FrameScene scene = scene_of({room.assets->meshes[0], room.assets->meshes[1], point},
                                {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, room.lights,
                                vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    scene.instances[1] = room.instances[1];
    VertexMap bench;
    const Deviation a = against(bench.settled(scene), path_traced(scene, kSize, 2, 64));
    EXPECT_NEAR(a.mean, 1, 0.05);
}

}  // namespace
}  // namespace lanthorn::gi::test
