// What runs in which frame, and why.
#include "gi_module/techniques/vertex-map/vertex_map_plan.h"

#include <gtest/gtest.h>

#include "gi_module/techniques/vertex-map/vertex_map_settings.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

FrameScene room(float albedo = 0.6f) {
    return support::scene_of({support::box(vec3(0), vec3(4), true, 0)}, {support::lambertian(vec3(albedo))},
                             {support::point_light(vec3(2), 100)}, vec3(1), vec3(2));
}

FrameScene still() {
    FrameScene scene = room();
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

// Once all is done.
VertexMapHistory done() {
    VertexMapHistory history;
    history.has_picture = history.has_photons = history.has_estimates = true;
    return history;
}

int passes_on(const VertexMapPlan& plan) {
    int on = 0;
    for (const VertexMapPlan::Step& step : plan.steps) {
        on += step.on ? 1 : 0;
    }
    return on;
}

// With a mirror in it.
FrameScene mirrored(FrameScene scene) {
    Material mirror;
    mirror.roughness = 0;
    const FrameScene with_mirror = support::scene_of(
        {support::box(vec3(0), vec3(4), true, 0),
         support::quad(vec3(0, 1, 1), vec3(1, 0, 0), vec3(0, 1, 0), 1)},
        {support::lambertian(vec3(0.6f)), mirror}, {support::point_light(vec3(2), 100)}, vec3(1), vec3(2));
    scene.assets = with_mirror.assets;
    scene.instances = with_mirror.instances;
    return scene;
}

TEST(VertexMapPlan, TheFirstFrameShootsAllPhotons) {
    const VertexMapPlan plan = make_vertex_map_plan(mirrored(room()), {}, {});
    EXPECT_EQ(plan.photons, static_cast<std::uint64_t>(VertexMapSettings().total));
    EXPECT_TRUE(plan.begins_again);
    EXPECT_EQ(passes_on(plan), static_cast<int>(kVertexMapPasses));
}

TEST(VertexMapPlan, AStillSceneThatIsDoneRunsNothing) {
    EXPECT_EQ(passes_on(make_vertex_map_plan(still(), {}, done())), 0);
}

TEST(VertexMapPlan, PhotonsThatAreLeftAreShotThoughNothingChanges) {
    VertexMapHistory history = done();
    history.left = 300;
    const VertexMapPlan plan = make_vertex_map_plan(still(), {}, history);
    EXPECT_EQ(plan.photons, 300u);
    EXPECT_FALSE(plan.changed);
    EXPECT_FALSE(plan.on(VertexMapPass::corners));
    EXPECT_FALSE(plan.on(VertexMapPass::seen));
    EXPECT_TRUE(plan.on(VertexMapPass::estimates));
}

TEST(VertexMapPlan, ALampThatMovesRenewsTheOldestAndLooksAtNoTriangleAnew) {
    FrameScene scene = still();
    scene.changes.lights = true;
    const VertexMapPlan plan = make_vertex_map_plan(scene, {}, done());
    EXPECT_EQ(plan.photons, static_cast<std::uint64_t>(VertexMapSettings().per_frame));
    EXPECT_TRUE(plan.changed);
    EXPECT_FALSE(plan.begins_again);
    EXPECT_FALSE(plan.on(VertexMapPass::corners));
    EXPECT_FALSE(plan.on(VertexMapPass::seen));
}

TEST(VertexMapPlan, ACameraThatMovesShootsNothing) {
    FrameScene scene = still();
    scene.changes.camera = true;
    const VertexMapPlan plan = make_vertex_map_plan(scene, {}, done());
    EXPECT_EQ(plan.photons, 0u);
    EXPECT_TRUE(plan.on(VertexMapPass::seen));
    EXPECT_TRUE(plan.on(VertexMapPass::estimates));
    EXPECT_TRUE(plan.on(VertexMapPass::picture));
}

TEST(VertexMapPlan, AThingThatMovesMovesItsCorners) {
    FrameScene scene = still();
    scene.changes.geometry = true;
    EXPECT_TRUE(make_vertex_map_plan(scene, {}, done()).on(VertexMapPass::corners));
}

TEST(VertexMapPlan, LevelsBoundTheReflections) {
    GiSettings settings;
    settings.bounces = 8;
    EXPECT_EQ(make_vertex_map_plan(room(), settings, {}).bounces, 2);
    settings.edit<VertexMapSettings>().max_level = 6;
    EXPECT_EQ(make_vertex_map_plan(room(), settings, {}).bounces, 5);
    settings.bounces = 1;
    EXPECT_EQ(make_vertex_map_plan(room(), settings, {}).bounces, 1);
    settings.edit<VertexMapSettings>().max_level = 1;
    EXPECT_EQ(make_vertex_map_plan(room(), settings, {}).bounces, 0);
    EXPECT_EQ(make_vertex_map_plan(room(), settings, {}).levels, 1);
}

TEST(VertexMapPlan, WithoutLightOrAlbedoNothingRuns) {
    FrameScene dark = room();
    dark.lights.clear();
    EXPECT_EQ(passes_on(make_vertex_map_plan(dark, {}, {})), 0);
    const VertexMapPlan black = make_vertex_map_plan(room(0), {}, {});
    EXPECT_EQ(passes_on(black), 0);
    EXPECT_EQ(black.unlit, Unlit::nothing_reflects);
}

TEST(VertexMapPlan, SaysWhyInWords) {
    const GiPlan plan = first_vertex_map_plan(room(), {});
    ASSERT_EQ(plan.entries.size(), kVertexMapPasses);
    for (const PlanEntry& entry : plan.entries) {
        EXPECT_FALSE(entry.pass.empty());
        EXPECT_FALSE(entry.why.empty());
    }
    EXPECT_EQ(plan.entries[1].size, "20000 of 20000, 3 hits each");
}

TEST(VertexMapPlan, MirrorsAreFollowedAnewOnlyWhereTheyShowOtherPlaces) {
    GiSettings settings;
    VertexMapHistory history = done();
    history.has_mirrors = true;
    EXPECT_EQ(passes_on(make_vertex_map_plan(mirrored(still()), settings, history)), 0);
    history.left = 100;  // other light
    VertexMapPlan plan = make_vertex_map_plan(mirrored(still()), settings, history);
    EXPECT_TRUE(plan.on(VertexMapPass::mirrors));
    EXPECT_FALSE(plan.on(VertexMapPass::mirror_rays));
    FrameScene turned = mirrored(still());
    turned.changes.camera = true;
    EXPECT_TRUE(make_vertex_map_plan(turned, settings, done()).on(VertexMapPass::mirror_rays));
    plan = make_vertex_map_plan(room(), settings, {});
    EXPECT_FALSE(plan.mirrors || plan.on(VertexMapPass::mirrors));
    settings.specular_roughness = 0;
    EXPECT_FALSE(make_vertex_map_plan(mirrored(room()), settings, {}).mirrors);
}

TEST(VertexMapPlan, HasWordsForEveryReason) {
    for (int i = 0; i <= static_cast<int>(VertexMapReason::mirrors_hold); ++i) {
        VertexMapPlan plan;
        plan.steps.fill({true, static_cast<VertexMapReason>(i)});
        for (const PlanEntry& e : in_words(plan, {}).entries) {
            EXPECT_FALSE(e.why.empty()) << i;
        }
    }
}

// Whatever shoots rays at the scene.
TEST(VertexMapPlan, TheSceneIsFollowedForPhotonsMirrorsAndSensors) {
    const auto follows = [](const FrameScene& scene, const VertexMapHistory& history) {
        return make_vertex_map_plan(scene, {}, history).on(VertexMapPass::acceleration_structure);
    };
    EXPECT_FALSE(follows(still(), done()));
    VertexMapHistory history = done();
    history.left = 100;
    EXPECT_TRUE(follows(still(), history));
    EXPECT_TRUE(follows(mirrored(still()), done()));  // whose rays have not been shot yet
    history = done();
    history.has_mirrors = true;
    EXPECT_FALSE(follows(mirrored(still()), history));
    FrameScene with_sensor = still();
    with_sensor.sensors = {{7, vec3(2, 0, 2), vec3(0, 1, 0), 0.1f}};
    EXPECT_TRUE(follows(with_sensor, done()));
}

}  // namespace
}  // namespace lanthorn::gi
