#include "gi_module/techniques/drm/drm_plan.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "gi_module/techniques/drm/drm_settings.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

static_assert(std::is_trivially_copyable_v<DrmPlan>, "a frame that nobody prints makes no words");

FrameScene room(const Material& walls = support::lambertian(vec3(0.7f))) {
    return support::scene_of({support::box(vec3(-1), vec3(1), true, 0)}, {walls},
                             {support::point_light(vec3(0), 10)}, vec3(0.5f), vec3(0));
}

FrameScene still(FrameScene scene) {
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

DrmHistory before() {
    return {.has_samples = true,
            .same_samples = true,
            .same_pixels = true,
            .has_picture = true,
            .has_mirrors = true,
            .can_trace = true};
}

TEST(DrmPlan, TheFirstFrameDoesWhatTheSceneNeeds) {
    const DrmPlan plan = make_drm_plan(room(), {}, {});
    EXPECT_EQ(plan.bounces, 1);
    EXPECT_TRUE(plan.on(DrmPass::samples) && plan.on(DrmPass::gather));
    EXPECT_FALSE(plan.on(DrmPass::lamp_pictures) || plan.on(DrmPass::mirrors) || plan.on(DrmPass::lobes));
}

TEST(DrmPlan, AStillSceneDoesNothing) {
    for (const Material& walls : {support::lambertian(vec3(0.7f)), support::metal(vec3(1), 0)}) {
        const DrmPlan plan = make_drm_plan(still(room(walls)), {}, before());
        for (std::size_t pass = 0; pass < kDrmPasses; ++pass) {
            EXPECT_FALSE(plan.steps[pass].on) << pass;
        }
    }
}

TEST(DrmPlan, ACameraGathersAndALampSamples) {
    FrameScene scene = still(room());
    scene.changes.camera = true;
    DrmPlan plan = make_drm_plan(scene, {}, before());
    EXPECT_TRUE(plan.on(DrmPass::gather));
    EXPECT_FALSE(plan.on(DrmPass::samples));
    scene = still(room());
    scene.changes.lights = true;
    plan = make_drm_plan(scene, {}, before());
    EXPECT_TRUE(plan.on(DrmPass::gather) && plan.on(DrmPass::samples));
}

TEST(DrmPlan, ALampLightsMirrorsAnewWithoutRays) {
    FrameScene scene = still(room(support::metal(vec3(1), 0)));
    scene.changes.lights = true;
    DrmPlan plan = make_drm_plan(scene, {}, before());
    EXPECT_TRUE(plan.on(DrmPass::mirrors));
    EXPECT_FALSE(plan.shoot || plan.on(DrmPass::acceleration_structure));
    scene.changes.camera = true;
    EXPECT_TRUE(make_drm_plan(scene, {}, before()).shoot);
}

TEST(DrmPlan, OtherSettingsMakeSamplesAnew) {
    DrmHistory history = before();
    history.same_samples = false;
    DrmPlan plan = make_drm_plan(still(room()), {}, history);
    EXPECT_TRUE(plan.on(DrmPass::samples) && plan.on(DrmPass::gather));
    history = before();
    history.same_pixels = false;
    plan = make_drm_plan(still(room()), {}, history);
    EXPECT_FALSE(plan.on(DrmPass::samples));
    EXPECT_TRUE(plan.on(DrmPass::gather));
}

TEST(DrmPlan, SamplesLookWhereThatIsAskedForAndTheyAreNew) {
    GiSettings settings;
    EXPECT_FALSE(make_drm_plan(room(), settings, {}).on(DrmPass::sample_pictures));
    settings.edit<DrmSettings>().second = 1;
    EXPECT_TRUE(make_drm_plan(room(), settings, {}).on(DrmPass::sample_pictures));
    FrameScene scene = still(room());
    scene.changes.camera = true;
    const DrmPlan plan = make_drm_plan(scene, settings, before());
    EXPECT_FALSE(plan.on(DrmPass::sample_pictures)) << "what samples see does not hang on the camera";
    EXPECT_EQ(plan.why(DrmPass::sample_pictures), DrmReason::samples_hold);
}

TEST(DrmPlan, SaysWhyThereAreNoMirrors) {
    const auto why = [](const FrameScene& scene, float roughness, bool can_trace) {
        GiSettings settings;
        settings.specular_roughness = roughness;
        DrmHistory history = before();
        history.can_trace = can_trace;
        return in_words(make_drm_plan(scene, settings, history), settings, {})
            .entries[static_cast<std::size_t>(DrmPass::mirrors)]
            .why;
    };
    EXPECT_EQ(why(room(), 0.5f, true), "no surface is smooth enough or transparent");
    EXPECT_EQ(why(room(support::metal(vec3(1), 0)), 0, true), "gi.specular.roughness is 0");
    EXPECT_EQ(why(room(support::metal(vec3(1), 0)), 0.5f, false), "this program has no rays for mirrors");
}

TEST(DrmPlan, HasWordsForEveryReason) {
    for (int i = 0; i <= static_cast<int>(DrmReason::lobes_are_wide); ++i) {
        DrmPlan plan;
        plan.steps.fill({true, static_cast<DrmReason>(i)});
        for (const PlanEntry& e : in_words(plan, {}, {}).entries) {
            EXPECT_FALSE(e.why.empty()) << i;
        }
    }
}

TEST(DrmPlan, ASceneWithoutLightHasNoPasses) {
    FrameScene dark = still(room());
    dark.lights.clear();
    const GiPlan words = in_words(make_drm_plan(dark, {}, before()), {}, {});
    EXPECT_EQ(words.bounces, 0);
    ASSERT_EQ(words.entries.size(), kDrmPasses);
    for (const PlanEntry& e : words.entries) {
        EXPECT_FALSE(e.on) << e.pass;
        EXPECT_EQ(e.why, "the scene has no light: nothing to reflect");
    }
}

TEST(DrmPlan, ASkyAloneIsSaidToBeLeftOut) {
    FrameScene scene = room();
    scene.lights.clear();
    SkyImage image;
    image.width = 2;
    image.height = 1;
    image.radiance.assign(2, vec3(1));
    scene.sky.emplace().sky.image = std::make_shared<const SkyImage>(std::move(image));
    const GiPlan words = in_words(make_drm_plan(scene, {}, {}), {}, {});
    EXPECT_EQ(words.bounces, 0);
    EXPECT_EQ(words.entries[0].why, "the sky is the only light: it has no picture to take samples from");
}

TEST(DrmPlan, CountsLightsThatAreLeftOut) {
    DrmStatistics counted;
    counted.pictures = 8;
    counted.left_out = 3;
    const GiPlan words = in_words(make_drm_plan(room(), {}, {}), {}, counted);
    EXPECT_EQ(words.entries[static_cast<std::size_t>(DrmPass::samples)].size,
              "3 x 3 a light, 8 lights, 3 weaker ones are left out");
}

}  // namespace
}  // namespace lanthorn::gi
