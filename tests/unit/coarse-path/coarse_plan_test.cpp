#include "gi_module/techniques/coarse-path/coarse_plan.h"
#include "gi_module/techniques/coarse-path/coarse_settings.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace lanthorn::gi {
namespace {

static_assert(std::is_trivially_copyable_v<CoarsePlan>, "a frame that nobody prints makes no words");

FrameScene lit_room() {
    auto assets = std::make_shared<SceneAssets>();
    assets->meshes.emplace_back();
    Material material;
    material.base_colour = vec4(vec3(0.7f), 1);
    material.metallic = 0;
    assets->materials.push_back(material);
    FrameScene scene;
    scene.assets = assets;
    scene.instances.emplace_back();
    scene.lights.emplace_back();
    return scene;
}

FrameScene still_room() {
    FrameScene scene = lit_room();
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

CoarseHistory after(int still_frames) {
    return {.has_picture = true, .has_samples = true, .filtered = true, .still_frames = still_frames};
}

TEST(CoarsePlan, TheFirstFrameDoesEverything) {
    const CoarsePlan plan = make_coarse_plan(lit_room(), {}, {});
    for (std::size_t pass = 0; pass < kCoarsePasses; ++pass) {
        EXPECT_TRUE(plan.steps[pass].on) << pass;
    }
    EXPECT_EQ(plan.kept, CoarseSettings().history);
}

TEST(CoarsePlan, AStillPictureEndsItsPaths) {
    GiSettings settings;
    settings.edit<CoarseSettings>().still_history = 20;
    const CoarsePlan growing = make_coarse_plan(still_room(), settings, after(18));
    EXPECT_TRUE(growing.on(CoarsePass::paths) && growing.on(CoarsePass::filter));
    EXPECT_FALSE(growing.on(CoarsePass::points));
    EXPECT_EQ(growing.kept, 20);
    const CoarsePlan done = make_coarse_plan(still_room(), settings, after(19));
    for (std::size_t pass = 0; pass < kCoarsePasses; ++pass) {
        EXPECT_FALSE(done.steps[pass].on) << pass;
    }
    settings.accumulate = 100;
    EXPECT_TRUE(make_coarse_plan(still_room(), settings, after(19)).on(CoarsePass::paths));
}

TEST(CoarsePlan, ACameraFindsPointsAndALampDoesNot) {
    FrameScene scene = still_room();
    scene.changes.camera = true;
    CoarsePlan plan = make_coarse_plan(scene, {}, after(100));
    EXPECT_TRUE(plan.on(CoarsePass::points) && plan.on(CoarsePass::paths));
    EXPECT_FALSE(plan.on(CoarsePass::acceleration_structure));
    scene.changes.camera = false;
    scene.changes.lights = true;
    plan = make_coarse_plan(scene, {}, after(100));
    EXPECT_FALSE(plan.on(CoarsePass::points) || plan.on(CoarsePass::acceleration_structure));
    EXPECT_TRUE(plan.on(CoarsePass::paths));
    EXPECT_EQ(plan.still_frames, 0);
}

TEST(CoarsePlan, AnotherFilterTracesNothing) {
    CoarseHistory history = after(100);
    history.filtered = false;
    const CoarsePlan plan = make_coarse_plan(still_room(), {}, history);
    EXPECT_TRUE(plan.on(CoarsePass::filter) && plan.on(CoarsePass::upsampling));
    EXPECT_FALSE(plan.on(CoarsePass::paths) || plan.on(CoarsePass::points));
}

TEST(CoarsePlan, SamplesThatWereDroppedHavePointsAgain) {
    CoarseHistory history = after(100);
    history.has_samples = false;
    const CoarsePlan plan = make_coarse_plan(still_room(), {}, history);
    EXPECT_TRUE(plan.on(CoarsePass::points) && plan.on(CoarsePass::paths));
    EXPECT_EQ(plan.still_frames, 0);
}

TEST(CoarsePlan, ASceneWithoutLightHasNoPasses) {
    FrameScene dark = still_room();
    dark.lights.clear();
    const GiPlan words = in_words(make_coarse_plan(dark, {}, after(3)), {});
    EXPECT_EQ(words.bounces, 0);
    for (const PlanEntry& e : words.entries) {
        EXPECT_FALSE(e.on) << e.pass;
        EXPECT_EQ(e.why, "the scene has no light: nothing to reflect");
    }
}

}  // namespace
}  // namespace lanthorn::gi
