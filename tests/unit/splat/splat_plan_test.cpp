#include "gi_module/techniques/splat/splat_plan.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "gi_module/techniques/splat/splat_technique.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/splat/splat.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace splat_plan_test {

static_assert(std::is_trivially_copyable_v<SplatPlan>, "a frame that nobody prints makes no words");

FrameScene room() {
    return support::scene_of({support::box(vec3(0), vec3(1), true, 0)}, {support::lambertian(vec3(0.5f))},
                             {support::point_light(vec3(0.5f), 1)}, vec3(0.5f), vec3(1));
}

FrameScene still_room() {
    FrameScene scene = room();
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

GiSettings settings() {
    GiSettings result;
    result.photons = 1000;
    result.edit<SplatSettings>().photons = 10'000;
    result.edit<SplatSettings>().batch = 3000;
    return result;
}

SplatHistory after(std::uint64_t walks, std::uint64_t splatted) {
    return {.walks = walks, .splatted = splatted, .has_photons = true, .has_picture = true, .has_view = true};
}

// With a mirror in it.
FrameScene mirrored(FrameScene scene) {
    Material mirror;
    mirror.roughness = 0;
    const FrameScene with_mirror =
        support::scene_of({support::box(vec3(0), vec3(1), true, 0),
                           support::quad(vec3(0, 0.2f, 0.2f), vec3(0.3f, 0, 0), vec3(0, 0.3f, 0), 1)},
                          {support::lambertian(vec3(0.5f)), mirror}, {support::point_light(vec3(0.5f), 1)},
                          vec3(0.5f), vec3(1));
    scene.assets = with_mirror.assets;
    scene.instances = with_mirror.instances;
    return scene;
}

TEST(SplatPlan, MirrorsAreFollowedAnewOnlyWhereTheyShowOtherPlaces) {
    SplatHistory history = after(10'000, 10'000);
    history.has_mirrors = true;
    SplatPlan plan = make_splat_plan(mirrored(still_room()), settings(), history);
    EXPECT_FALSE(plan.on(SplatPass::mirrors) || plan.on(SplatPass::mirror_rays));
    history.walks = history.splatted = 1000;  // twice as many come
    plan = make_splat_plan(mirrored(still_room()), settings(), history);
    EXPECT_TRUE(plan.on(SplatPass::mirrors));
    EXPECT_FALSE(plan.on(SplatPass::mirror_rays));
    FrameScene turned = mirrored(still_room());
    turned.changes.camera = true;
    EXPECT_TRUE(make_splat_plan(turned, settings(), history).on(SplatPass::mirror_rays));
    EXPECT_FALSE(make_splat_plan(room(), settings(), {}).mirrors);
    GiSettings off = settings();
    off.specular_roughness = 0;
    EXPECT_FALSE(make_splat_plan(mirrored(room()), off, {}).mirrors);
}

TEST(SplatPlan, TheFirstFrameDoesEverything) {
    const SplatPlan plan = make_splat_plan(mirrored(room()), settings(), {});
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_TRUE(plan.steps[pass].on) << pass;
    }
    EXPECT_EQ(plan.grow, 1000u);
}

TEST(SplatPlan, AStillPictureDoublesThenGrowsByBatchesToItsEndAndRests) {
    std::uint64_t walks = 1000, splatted = 1000;
    std::vector<std::uint64_t> steps, pictures;
    for (int frame = 0; frame < 20; ++frame) {
        const SplatPlan plan = make_splat_plan(still_room(), settings(), after(walks, splatted));
        EXPECT_FALSE(plan.anew || plan.on(SplatPass::item_buffer) || plan.on(SplatPass::surfaces));
        if (plan.grow > 0) {
            steps.push_back(plan.grow);
        }
        walks += plan.grow;
        if (plan.on(SplatPass::splats)) {
            splatted = walks;
            pictures.push_back(walks);
        }
    }
    EXPECT_EQ(steps, (std::vector<std::uint64_t>{1000, 2000, 3000, 3000}));
    EXPECT_EQ(pictures, (std::vector<std::uint64_t>{2000, 4000, 10'000}));
    const SplatPlan done = make_splat_plan(still_room(), settings(), after(walks, splatted));
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_FALSE(done.steps[pass].on) << pass;
    }
}

TEST(SplatPlan, AnotherViewIsSplattedWithoutATrace) {
    FrameScene scene = still_room();
    scene.changes.camera = true;
    const SplatPlan plan = make_splat_plan(scene, settings(), after(10'000, 10'000));
    EXPECT_TRUE(plan.on(SplatPass::item_buffer) && plan.on(SplatPass::splats));
    EXPECT_FALSE(plan.on(SplatPass::photons) || plan.on(SplatPass::surfaces) || plan.anew);
}

TEST(SplatPlan, LightAndGeometryTraceAnew) {
    for (const bool light : {true, false}) {
        FrameScene scene = still_room();
        (light ? scene.changes.lights : scene.changes.geometry) = true;
        const SplatPlan plan = make_splat_plan(scene, settings(), after(10'000, 10'000));
        EXPECT_TRUE(plan.anew && plan.on(SplatPass::splats));
        EXPECT_EQ(plan.grow, 1000u);
        EXPECT_EQ(plan.on(SplatPass::surfaces), !light);
    }
}

TEST(SplatPlan, AFullDiskEndsGrowth) {
    SplatHistory history = after(4000, 4000);
    history.full = true;
    const SplatPlan plan = make_splat_plan(still_room(), settings(), history);
    EXPECT_FALSE(plan.on(SplatPass::photons) || plan.on(SplatPass::splats));
    EXPECT_NE(plan_table(in_words(plan, settings())).find("disk"), std::string::npos);
    // What was kept before it was full is shown, though it is not twice as much.
    history = after(6000, 4000);
    history.full = true;
    EXPECT_TRUE(make_splat_plan(still_room(), settings(), history).on(SplatPass::splats));
}

TEST(SplatPlan, NoLightNeedsNothing) {
    FrameScene scene = room();
    scene.lights.clear();
    const SplatPlan plan = make_splat_plan(scene, settings(), {});
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_FALSE(plan.steps[pass].on) << pass;
    }
}

TEST(SplatPlan, ZeroPhotonsAreAPictureToo) {
    GiSettings none = settings();
    none.photons = 0;
    none.edit<SplatSettings>().photons = 0;
    const SplatPlan plan = make_splat_plan(room(), none, {});
    EXPECT_FALSE(plan.on(SplatPass::photons));
    EXPECT_TRUE(plan.on(SplatPass::splats));
    EXPECT_FALSE(make_splat_plan(still_room(), none, after(0, 0)).on(SplatPass::splats));
}

TEST(SplatSettingsTest, AreTakenInRangeAndRefusedOutOfIt) {
    const TechniqueKind kind = add_splat();
    SettingsSchema schema;
    declare_gi_settings(schema);
    Settings s(schema);
    for (const char* assignment :
         {"gi.technique=splat", "gi.splat.photons=5", "gi.splat.bandwidth=7", "gi.splat.kernel=epanechnikov",
          "gi.splat.boundaries=false", "gi.splat.adaptive=all", "gi.splat.scattering=full",
          "gi.splat.memory=100"}) {
        s.set_from_text(assignment);
    }
    const GiSettings gi = gi_settings(s);
    const auto& own = gi.of<SplatSettings>();
    EXPECT_EQ(gi.technique, kind);
    EXPECT_EQ(own.photons, 5);
    EXPECT_EQ(own.bandwidth, 7);
    EXPECT_EQ(own.kernel, PhotonKernel::epanechnikov);
    EXPECT_FALSE(own.boundaries);
    EXPECT_EQ(own.adaptive, SplatAdaptive::all);
    EXPECT_EQ(own.scattering, PhotonScattering::full);
    EXPECT_EQ(own.memory, 100);
    for (const char* assignment :
         {"gi.splat.photons=-1", "gi.splat.bandwidth=0", "gi.splat.bandwidth=nan", "gi.splat.kernel=gauss",
          "gi.splat.levels=0", "gi.splat.memory=1", "gi.splat.batch=0", "gi.splat.bias=-1"}) {
        EXPECT_THROW(s.set_from_text(assignment), InputError) << assignment;
    }
}

TEST(SplatPlan, HasWordsForEveryReason) {
    for (int i = 0; i <= static_cast<int>(SplatReason::mirrors_hold); ++i) {
        SplatPlan plan;
        plan.steps.fill({true, static_cast<SplatReason>(i)});
        for (const PlanEntry& e : in_words(plan, {}).entries) {
            EXPECT_FALSE(e.why.empty()) << i;
        }
    }
}

}  // namespace splat_plan_test
}  // namespace lanthorn::gi::test
