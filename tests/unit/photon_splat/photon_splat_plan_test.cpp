#include "lanthorn/photon_splat/photon_splat_plan.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/photon_splat/photon_splat_technique.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

static_assert(std::is_trivially_copyable_v<PhotonSplatPlan>, "a frame that nobody prints makes no words");

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
    result.edit<PhotonSplatSettings>().photons = 10'000;
    result.edit<PhotonSplatSettings>().batch = 3000;
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

TEST(PhotonSplatPlan, MirrorsAreFollowedAnewOnlyWhereTheyShowOtherPlaces) {
    SplatHistory history = after(10'000, 10'000);
    history.has_mirrors = true;
    PhotonSplatPlan plan = make_photon_splat_plan(mirrored(still_room()), settings(), history);
    EXPECT_FALSE(plan.on(SplatPass::mirrors) || plan.on(SplatPass::mirror_rays));
    history.walks = history.splatted = 1000;  // twice as many come
    plan = make_photon_splat_plan(mirrored(still_room()), settings(), history);
    EXPECT_TRUE(plan.on(SplatPass::mirrors));
    EXPECT_FALSE(plan.on(SplatPass::mirror_rays));
    FrameScene turned = mirrored(still_room());
    turned.changes.camera = true;
    EXPECT_TRUE(make_photon_splat_plan(turned, settings(), history).on(SplatPass::mirror_rays));
    EXPECT_FALSE(make_photon_splat_plan(room(), settings(), {}).mirrors);
    GiSettings off = settings();
    off.specular_roughness = 0;
    EXPECT_FALSE(make_photon_splat_plan(mirrored(room()), off, {}).mirrors);
}

TEST(PhotonSplatPlan, TheFirstFrameDoesEverything) {
    const PhotonSplatPlan plan = make_photon_splat_plan(mirrored(room()), settings(), {});
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_TRUE(plan.steps[pass].on) << pass;
    }
    EXPECT_EQ(plan.grow, 1000u);
}

TEST(PhotonSplatPlan, AStillPictureDoublesThenGrowsByBatchesToItsEndAndRests) {
    std::uint64_t walks = 1000, splatted = 1000;
    std::vector<std::uint64_t> steps, pictures;
    for (int frame = 0; frame < 20; ++frame) {
        const PhotonSplatPlan plan = make_photon_splat_plan(still_room(), settings(), after(walks, splatted));
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
    const PhotonSplatPlan done = make_photon_splat_plan(still_room(), settings(), after(walks, splatted));
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_FALSE(done.steps[pass].on) << pass;
    }
}

TEST(PhotonSplatPlan, AnotherViewIsSplattedWithoutATrace) {
    FrameScene scene = still_room();
    scene.changes.camera = true;
    const PhotonSplatPlan plan = make_photon_splat_plan(scene, settings(), after(10'000, 10'000));
    EXPECT_TRUE(plan.on(SplatPass::item_buffer) && plan.on(SplatPass::splats));
    EXPECT_FALSE(plan.on(SplatPass::photons) || plan.on(SplatPass::surfaces) || plan.anew);
}

TEST(PhotonSplatPlan, LightAndGeometryTraceAnew) {
    for (const bool light : {true, false}) {
        FrameScene scene = still_room();
        (light ? scene.changes.lights : scene.changes.geometry) = true;
        const PhotonSplatPlan plan = make_photon_splat_plan(scene, settings(), after(10'000, 10'000));
        EXPECT_TRUE(plan.anew && plan.on(SplatPass::splats));
        EXPECT_EQ(plan.grow, 1000u);
        EXPECT_EQ(plan.on(SplatPass::surfaces), !light);
    }
}

TEST(PhotonSplatPlan, AFullDiskEndsGrowth) {
    SplatHistory history = after(4000, 4000);
    history.full = true;
    const PhotonSplatPlan plan = make_photon_splat_plan(still_room(), settings(), history);
    EXPECT_FALSE(plan.on(SplatPass::photons) || plan.on(SplatPass::splats));
    EXPECT_NE(plan_table(in_words(plan, settings())).find("disk"), std::string::npos);
    // What was kept before it was full is shown, though it is not twice as much.
    history = after(6000, 4000);
    history.full = true;
    EXPECT_TRUE(make_photon_splat_plan(still_room(), settings(), history).on(SplatPass::splats));
}

TEST(PhotonSplatPlan, NoLightNeedsNothing) {
    FrameScene scene = room();
    scene.lights.clear();
    const PhotonSplatPlan plan = make_photon_splat_plan(scene, settings(), {});
    for (std::size_t pass = 0; pass < kSplatPasses; ++pass) {
        EXPECT_FALSE(plan.steps[pass].on) << pass;
    }
}

TEST(PhotonSplatPlan, ZeroPhotonsAreAPictureToo) {
    GiSettings none = settings();
    none.photons = 0;
    none.edit<PhotonSplatSettings>().photons = 0;
    const PhotonSplatPlan plan = make_photon_splat_plan(room(), none, {});
    EXPECT_FALSE(plan.on(SplatPass::photons));
    EXPECT_TRUE(plan.on(SplatPass::splats));
    EXPECT_FALSE(make_photon_splat_plan(still_room(), none, after(0, 0)).on(SplatPass::splats));
}

TEST(PhotonSplatSettingsTest, AreTakenInRangeAndRefusedOutOfIt) {
    const TechniqueKind kind = add_photon_splat();
    SettingsSchema schema;
    declare_gi_settings(schema);
    Settings s(schema);
    for (const char* assignment :
         {"gi.technique=splat", "gi.photon_splat.photons=5", "gi.photon_splat.bandwidth=7",
          "gi.photon_splat.kernel=epanechnikov", "gi.photon_splat.boundaries=false",
          "gi.photon_splat.adaptive=all", "gi.photon_splat.scattering=full", "gi.photon_splat.memory=100"}) {
        s.set_from_text(assignment);
    }
    const GiSettings gi = gi_settings(s);
    const auto& own = gi.of<PhotonSplatSettings>();
    EXPECT_EQ(gi.technique, kind);
    EXPECT_EQ(own.photons, 5);
    EXPECT_EQ(own.bandwidth, 7);
    EXPECT_EQ(own.kernel, PhotonKernel::epanechnikov);
    EXPECT_FALSE(own.boundaries);
    EXPECT_EQ(own.adaptive, SplatAdaptive::all);
    EXPECT_EQ(own.scattering, PhotonScattering::full);
    EXPECT_EQ(own.memory, 100);
    for (const char* assignment :
         {"gi.photon_splat.photons=-1", "gi.photon_splat.bandwidth=0", "gi.photon_splat.bandwidth=nan",
          "gi.photon_splat.kernel=gauss", "gi.photon_splat.levels=0", "gi.photon_splat.memory=1",
          "gi.photon_splat.batch=0", "gi.photon_splat.bias=-1"}) {
        EXPECT_THROW(s.set_from_text(assignment), InputError) << assignment;
    }
}

TEST(PhotonSplatPlan, HasWordsForEveryReason) {
    for (int i = 0; i <= static_cast<int>(SplatReason::mirrors_hold); ++i) {
        PhotonSplatPlan plan;
        plan.steps.fill({true, static_cast<SplatReason>(i)});
        for (const PlanEntry& e : in_words(plan, {}).entries) {
            EXPECT_FALSE(e.why.empty()) << i;
        }
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
