// Paths from points of a scene that changes from frame to frame.
#include "gi_module/techniques/coarse-path/point_paths.h"

#include <gtest/gtest.h>

#include "tests/support/closed_forms.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

using support::lambertian;
using support::point_light;
using support::scene_of;

// A room with a block, and a lamp.
FrameScene room() {
    return scene_of({support::box(vec3(0), vec3(4, 2.6f, 3), true, 0),
                     support::box(vec3(-0.4f, 0, -0.8f), vec3(0.4f, 2.0f, 0.8f), false, 1)},
                    {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                    {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

void place_block(FrameScene& scene, float x) {
    Instance& block = scene.instances[1];
    block.transform = mat4(1);
    block.transform[3] = vec4(x, 0, 1.5f, 1);
    block.bounds = transformed(scene.assets->meshes[1].bounds, block.transform);
    scene.changes = {};
    scene.changes.assets = scene.changes.lights = scene.changes.camera = false;
    scene.changes.moved = {1};
}

// On the floor and on a wall.
GridPoints points_in_the_room() {
    GridPoints points{ivec2(32, 8), 1, ivec2(32, 8), {}};
    for (int i = 0; i < 256; ++i) {
        const float a = 0.05f + 0.9f * static_cast<float>(i % 16) / 16;
        const float b = 0.05f + 0.9f * static_cast<float>(i / 16 % 8) / 8;
        const bool wall = i >= 128;
        const auto word = static_cast<std::uint32_t>(i % 32 | i / 32 << 16);
        points.points.push_back(wall ? SurfacePoint{{4 * a, 2.6f * b, 0}, 2, {0, 0, 1}, word}
                                     : SurfacePoint{{4 * a, 0, 3 * b}, 2, {0, 1, 0}, word});
    }
    return points;
}

std::vector<PointEstimate> traced(PointPaths& paths, const GridPoints& points, int threads, int count = 4) {
    reference::TileWorkers workers(threads);
    std::vector<PointEstimate> estimates(points.points.size());
    paths.trace(points, std::vector<int>(points.points.size(), count), 2, 1, estimates, workers);
    return estimates;
}

bool same(const std::vector<PointEstimate>& a, const std::vector<PointEstimate>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].irradiance != b[i].irradiance || a[i].second != b[i].second ||
            a[i].samples != b[i].samples) {
            return false;
        }
    }
    return true;
}

TEST(PointPaths, AreTheSameOnOneThreadAndOnTwo) {
    FrameScene scene = room();
    place_block(scene, 2);
    const GridPoints points = points_in_the_room();
    PointPaths one, two;
    one.follow(scene);
    two.follow(scene);
    EXPECT_TRUE(same(traced(one, points, 1), traced(two, points, 2)));
    // And the next samples, which are others.
    const auto next = traced(one, points, 1);
    EXPECT_TRUE(same(next, traced(two, points, 2)));
    PointPaths anew;
    anew.follow(scene);
    EXPECT_FALSE(same(next, traced(anew, points, 1)));
}

// What is refitted meets the same surfaces as what is built whole.
TEST(PointPaths, FollowWhatMovesAsIfBuiltAnew) {
    FrameScene scene = room();
    place_block(scene, 2);
    const GridPoints points = points_in_the_room();
    PointPaths kept;
    kept.follow(scene);
    const auto before = traced(kept, points, 1);
    FrameScene next = scene;
    for (const float x : {2.3f, 2.9f, 1.7f}) {
        place_block(next, x);
        kept.follow(next);
    }
    EXPECT_EQ(kept.builds(), 1u);
    PointPaths anew;
    anew.follow(next);
    traced(anew, points, 1);  // as many samples before
    const auto now = traced(kept, points, 1);
    EXPECT_TRUE(same(now, traced(anew, points, 1)));
    EXPECT_FALSE(same(now, before));
}

TEST(PointPaths, FollowLightsAndPaint) {
    FrameScene scene = room();
    place_block(scene, 2);
    const GridPoints points = points_in_the_room();
    PointPaths kept;
    kept.follow(scene);
    FrameScene next = scene;
    next.changes.moved.clear();
    next.changes.geometry = false;
    next.lights[0].position.x += 0.5f;
    auto assets = std::make_shared<SceneAssets>(*scene.assets);
    assets->materials = std::vector{lambertian(vec3(0.2f)), lambertian(vec3(0.7f))};
    next.assets = assets;
    next.changes.assets = true;
    next.changes.painted = {0, 1};
    kept.follow(next);
    EXPECT_EQ(kept.builds(), 1u);
    PointPaths anew;
    anew.follow(next);
    EXPECT_TRUE(same(traced(kept, points, 1), traced(anew, points, 1)));
}

TEST(PointPaths, AreThoseOfAFreshSceneWhenSomethingGoes) {
    FrameScene scene = room();
    place_block(scene, 2);
    const GridPoints points = points_in_the_room();
    PointPaths kept;
    kept.follow(scene);
    FrameScene next = scene;
    next.instances.pop_back();
    next.changes.moved.clear();
    kept.follow(next);
    EXPECT_EQ(kept.builds(), 1u);
    PointPaths fresh;
    fresh.follow(next);
    EXPECT_TRUE(same(traced(kept, points, 1), traced(fresh, points, 1)));
}

// From inside a closed sphere with a lamp at its centre: the geometric series, at every point.
TEST(PointPaths, GiveTheClosedSpheresLight) {
    FrameScene scene = scene_of({support::sphere(vec3(0), 1, 4, true, 0)}, {lambertian(vec3(0.5f))},
                                {point_light(vec3(0), 100)}, vec3(0, 0, 0.5f), vec3(0, 0, -1));
    PointPaths paths;
    paths.follow(scene);
    GridPoints points{ivec2(16, 16), 1, ivec2(16, 16), {}};
    for (std::uint32_t i = 0; i < 256; ++i) {
        // The sphere has facets: start a little inside.
        const float z = 1 - (2 * static_cast<float>(i) + 1) / 256, turn = 2.4f * static_cast<float>(i);
        const vec3 n = -vec3(std::sqrt(1 - z * z) * vec2(std::cos(turn), std::sin(turn)), z);
        points.points.push_back({-0.99f * n, 1, n, i % 16 | i / 16 << 16});
    }
    double sum = 0;
    for (const PointEstimate& estimate : traced(paths, points, 0, 64)) {
        sum += static_cast<double>(estimate.irradiance.x) / 256;
    }
    EXPECT_NEAR(sum / support::sphere_irradiance(100, 1, 0.5, 2), 1, 0.005);
    EXPECT_EQ(paths.nan_count(), 0u);
}

}  // namespace
}  // namespace lanthorn::gi::test
