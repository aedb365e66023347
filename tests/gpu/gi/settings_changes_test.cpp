// A change of settings makes anew what depends on them: a forgotten one is a stale picture.
#include <gtest/gtest.h>

#include <algorithm>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/render/render_settings.h"
#include "tests/gpu/gi/settings_walk.h"

namespace lanthorn::gi::test {
namespace {

FrameScene room_with_block() {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 2.0f, 2.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
        {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

// Small, but every setting still tells.
const std::vector<std::string> kSmall = {"gi.photons=600",     "gi.emc.count=3",     "gi.emc.candidates=6",
                                         "gi.gather.grid=8",   "gi.gather.points=1", "gi.emc.resolution=32",
                                         "gi.emc.splat.base=4"};

bool has(const std::vector<std::string>& names, const char* name) {
    return std::ranges::find(names, name) != names.end();
}

TEST(SettingsChanges, SplatsAreThoseOfAFreshTechnique) {
    std::vector<std::string> base = kSmall;
    base.insert(base.end(), {"gi.emc.final=splat", "gi.accumulate=2"});
    const auto altered = walk_settings(room_with_block(), base, 3);
    for (const char* name :
         {"gi.technique", "gi.bounces", "gi.photons", "gi.seed", "gi.accumulate", "gi.emc.count",
          "gi.emc.candidates", "gi.emc.resolution", "gi.emc.search", "gi.emc.steps", "gi.emc.final",
          "gi.emc.splat.bandwidth", "gi.emc.splat.c0", "gi.emc.splat.base", "gi.emc.splat.contrast"}) {
        EXPECT_TRUE(has(altered, name)) << name;
    }
    for (const char* name : {"gi.emc.update_interval", "gi.emc.fade_frames", "gi.gather.grid"}) {
        EXPECT_FALSE(has(altered, name)) << name;
    }
}

TEST(SettingsChanges, TheGatherIsThatOfAFreshTechnique) {
    std::vector<std::string> base = kSmall;
    // Which maps are reserved, and what rays from before have met in them, depends on frames before; so does
    // where guided rays go, and more passes go on with the picture that there is (gather_still_test.cpp).
    base.insert(base.end(), {"gi.emc.final=gather", "gi.gather.rays=2", "gi.emc.reserved=0",
                             "gi.gather.guide=false", "gi.gather.endless=false"});
    const auto altered = walk_settings(room_with_block(), base, RememberedHits::kFrames + 1,
                                       {"gi.gather.guide", "gi.accumulate"});
    for (const char* name : {"gi.bounces", "gi.seed", "gi.emc.count", "gi.emc.resolution", "gi.emc.search",
                             "gi.emc.final", "gi.gather.grid", "gi.gather.rays", "gi.gather.guide"}) {
        EXPECT_TRUE(has(altered, name)) << name;
    }
    EXPECT_FALSE(has(altered, "gi.emc.splat.c0"));
}

// Photons start from the light maps, which are render's.
TEST(SettingsChanges, LightMapsOfAnotherResolutionRenewThePhotons) {
    for (const EmcFinal stage : {EmcFinal::splat, EmcFinal::gather}) {
        const int frames = stage == EmcFinal::splat ? 1 : RememberedHits::kFrames + 1;
        const auto picture = [&](Bench& bench, FrameScene& scene, int resolution) {
            bench.settings.photons = 2000;
            bench.settings.edit<EmcSettings>().final_stage = stage;
            bench.settings.edit<EmcSettings>().gather_guide = false;  // by light before: rays would be others
            bench.settings.edit<EmcSettings>().gather_endless = false;  // goes on from light before, too
            render::RenderSettings settings;
            settings.shadow_resolution = resolution;
            bench.app.world().insert_resource(settings);
            std::vector<float> pixels;
            for (int i = 0; i < frames; ++i) {
                pixels = bench.frame(scene, ivec2(64)).pixels;
                hold_still(scene);
            }
            return pixels;
        };
        Bench kept;
        FrameScene scene = room_with_block();
        const std::vector<float> before = picture(kept, scene, 256);
        const std::vector<float> coarser = picture(kept, scene, 64);
        EXPECT_NE(coarser, before);
        const GiPlan plan = kept.technique().statistics(false).plan;
        EXPECT_EQ(plan.on("emission"), stage == EmcFinal::splat);
        Bench fresh;
        FrameScene again = room_with_block();
        EXPECT_EQ(coarser, picture(fresh, again, 64));
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
