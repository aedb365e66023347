// Which passes a frame has that gathers from lit maps.
#include "gi_module/techniques/emc/emc_plan.h"

#include <gtest/gtest.h>

#include "lanthorn/emc/emc_settings.h"
#include "tests/unit/emc/emc_plan_scenes.h"

namespace lanthorn::gi {
namespace emc_plan_test {

using test::by_splats;
using test::counted_gather;
using test::EmcFrames;
using test::first_plan_of;
using test::hold_still;
using test::lit_room;
using test::running;
using test::settled;

TEST(EmcPlan, TheGatherShootsWhatIsNotRememberedYet) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings = counted_gather();
    const EmcPlan first = first_plan_of(scene, settings);
    for (const EmcPass pass : {EmcPass::selection, EmcPass::environment_maps, EmcPass::lit_maps,
                               EmcPass::gather, EmcPass::filter, EmcPass::upsampling}) {
        EXPECT_TRUE(first.on(pass)) << static_cast<int>(pass);
    }
    EXPECT_FALSE(first.on(EmcPass::emission) || first.on(EmcPass::emission) || first.on(EmcPass::splats));

    hold_still(scene);
    EmcFrames frames = running(scene, settings);
    frames.kept.texel_frames = frames.kept.point_frames = 15;
    const EmcPlan last = frames.next(scene, settings);
    EXPECT_TRUE(last.lit.shoot && last.gather.shoot && last.on(EmcPass::gather));
    EXPECT_FALSE(last.lit.look || last.lit.light || last.gather.points);

    frames.kept.texel_frames = frames.kept.point_frames = 16;
    const EmcPlan still = frames.next(scene, settings);
    EXPECT_FALSE(still.lit.shoot || still.gather.shoot || still.on(EmcPass::gather) || still.lit.light);
    scene.changes.lights = true;
    const EmcPlan light = frames.next(scene, settings);
    EXPECT_TRUE(light.lit.light && light.on(EmcPass::gather));
    EXPECT_FALSE(light.lit.shoot || light.gather.shoot || light.lit.look || light.gather.points);
    scene.changes.lights = false;
    scene.changes.camera = true;
    const EmcPlan view = frames.next(scene, settings);
    EXPECT_TRUE(view.gather.points && view.gather.shoot);
    EXPECT_FALSE(view.lit.shoot || view.lit.light);
    scene.changes.painted = {0};
    frames.kept.texel_frames = frames.kept.point_frames = 16;
    scene.changes.camera = false;
    const EmcPlan paint = frames.next(scene, settings);
    EXPECT_TRUE(paint.lit.recolour && paint.lit.light_all && paint.on(EmcPass::gather));
    EXPECT_FALSE(paint.lit.look || paint.lit.shoot || paint.gather.points || paint.gather.shoot)
        << "rays still meet what they met";
    scene.changes.painted.clear();
    // A lamp of glowing glass flickers while something moves.
    scene.changes.assets = scene.changes.emission = scene.changes.geometry = true;
    const EmcPlan flicker = frames.next(scene, settings);
    EXPECT_TRUE(flicker.lit.look && flicker.lit.light_all);
    EXPECT_FALSE(flicker.lit.look_all) << "only texels near what moves look at the maps again";

    scene.sensors.emplace_back();
    EXPECT_TRUE(first_plan_of(scene, settings).on(EmcPass::emission));  // sensors count photons
}

TEST(EmcPlan, PhotonsLightTheMapsWhereRaysDoNot) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings = counted_gather();
    settings.edit<EmcSettings>().gather_source = GatherSource::photons;
    const EmcPlan first = first_plan_of(scene, settings);
    EXPECT_TRUE(first.by_photons() && first.on(EmcPass::lit_photons) && first.on(EmcPass::lit_maps));
    EXPECT_FALSE(first.lit.shoot || first.on(EmcPass::emission));
    EXPECT_EQ(first.lit.photon_bounces, settings.bounces - 1) << "the picture sees them reflected once more";

    hold_still(scene);
    EmcFrames frames = running(scene, settings);
    frames.kept.point_frames = 16;
    frames.kept.light_frames = 15;
    const EmcPlan last = frames.next(scene, settings);
    EXPECT_TRUE(last.on(EmcPass::lit_photons) && last.on(EmcPass::lit_maps) && last.on(EmcPass::gather));
    frames.kept.light_frames = 16;
    const EmcPlan still = frames.next(scene, settings);
    EXPECT_FALSE(still.on(EmcPass::lit_photons) || still.on(EmcPass::lit_maps) || still.on(EmcPass::gather));
    EXPECT_EQ(still.why(EmcPass::lit_photons), EmcReason::photons_are_in);
    GiSettings more = settings;
    more.edit<EmcSettings>().gather_photons *= 2;
    EXPECT_EQ(frames.next(scene, more).why(EmcPass::lit_photons), EmcReason::texels_count_photons);
    scene.changes.lights = true;
    EXPECT_TRUE(frames.next(scene, settings).on(EmcPass::lit_photons));

    settings.edit<EmcSettings>().gather_endless = true;
    EXPECT_EQ(first_plan_of(scene, settings).lit.photon_bounces, 4);
    settings.edit<EmcSettings>().gather_endless = false;
    settings.bounces = 1;
    EXPECT_EQ(first_plan_of(scene, settings).why(EmcPass::lit_photons), EmcReason::one_reflection);
    settings.bounces = 2;
    scene.sky.emplace();
    const EmcPlan both = first_plan_of(scene, settings);
    EXPECT_TRUE(both.by_photons() && both.lit.shoot && both.lit.sky_apart)
        << "photons of the lamps, rays for the sky";
    scene.lights.clear();
    const EmcPlan sky = first_plan_of(scene, settings);
    EXPECT_TRUE(sky.lit.shoot && sky.lit.sky_apart);
    EXPECT_FALSE(sky.by_photons());
    EXPECT_EQ(sky.why(EmcPass::lit_photons), EmcReason::sky_by_rays);
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    EXPECT_EQ(first_plan_of(scene, settings).why(EmcPass::lit_photons), EmcReason::texels_have_rays);
}

TEST(EmcPlan, WhatIsKnownOfSurfacesHoldsWhileItIsDark) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    const EmcFrames before = settled(scene, settings);
    hold_still(scene);
    FrameScene unlit = scene;
    unlit.lights.clear();
    unlit.changes.lights = true;

    EmcFrames dark = before;
    EXPECT_EQ(dark.run(unlit, settings).why(EmcPass::selection), EmcReason::no_indirect_light);
    // Whatever is said to have changed when there is light again.
    const EmcPlan light = dark.next(scene, settings);
    EXPECT_TRUE(light.lit.light && light.lit.light_all && light.lit.from_dark && light.on(EmcPass::gather));
    EXPECT_FALSE(light.on(EmcPass::selection) || light.lit.look || light.lit.shoot || light.gather.points ||
                 light.gather.shoot);
    EmcFrames splats = running(scene, by_splats());
    splats.run(unlit, by_splats());
    EXPECT_EQ(splats.next(scene, by_splats()).why(EmcPass::emission), EmcReason::light_changed);

    unlit.changes.camera = true;
    dark.run(unlit, settings);
    const EmcPlan view = dark.next(scene, settings);
    EXPECT_TRUE(view.gather.points);
    EXPECT_FALSE(view.on(EmcPass::selection) || view.lit.look);

    for (const auto& alter :
         {+[](SceneChanges& c) { c.geometry = true; }, +[](SceneChanges& c) { c.pattern = true; },
          +[](SceneChanges& c) { c.painted = {0}; }}) {
        EmcFrames other = before;
        FrameScene altered = unlit;
        alter(altered.changes);
        other.run(altered, settings);
        EXPECT_TRUE(other.next(scene, settings).on(EmcPass::selection));
    }
}

TEST(EmcPlan, AGatheredPictureIsRefinedOnceAllIsRemembered) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings = counted_gather();
    EXPECT_EQ(settled(scene, settings).next(scene, settings).why(EmcPass::accumulation),
              EmcReason::one_pass_is_all);
    settings.accumulate = 4;
    EmcFrames frames = settled(scene, settings);
    for (int passes = 1; passes <= 5; ++passes) {
        frames.kept.passes = passes;
        const EmcPlan plan = frames.next(scene, settings);
        EXPECT_EQ(plan.on(EmcPass::accumulation), passes < 4) << passes;
        EXPECT_EQ(plan.pass, passes < 4 ? passes : 0);
        EXPECT_FALSE(plan.on(EmcPass::gather) || plan.on(EmcPass::lit_maps));
    }
    frames.kept.passes = 1;
    frames.kept.point_frames = 15;
    const EmcPlan early = frames.next(scene, settings);
    EXPECT_FALSE(early.on(EmcPass::accumulation));
    EXPECT_EQ(early.why(EmcPass::accumulation), EmcReason::rays_first);
    frames.kept.point_frames = 16;
    scene.changes.lights = true;
    EXPECT_FALSE(frames.next(scene, settings).on(EmcPass::accumulation));
}

TEST(EmcPlan, SmallPicturesHaveAFinerGridOfPoints) {
    GiSettings settings;
    settings.edit<EmcSettings>().gather_grid = 4;
    settings.edit<EmcSettings>().gather_points = 6000;
    EXPECT_EQ(gather_stride(settings, ivec2(1920, 1080)), 4);
    EXPECT_EQ(gather_stride(settings, ivec2(320, 300)), 4) << "just enough";
    EXPECT_EQ(gather_stride(settings, ivec2(320, 299)), 3);
    EXPECT_EQ(gather_stride(settings, ivec2(128)), 1);
    EXPECT_EQ(gather_stride(settings, ivec2(1)), 1) << "no more points than pixels";
    settings.edit<EmcSettings>().gather_points = 1;
    EXPECT_EQ(gather_stride(settings, ivec2(128)), 4);
}

// What rays from lit texels go through tells nothing of photons.
TEST(EmcPlan, SensorsKeepPhotonsThatSettingsDoNotAlter) {
    FrameScene scene = lit_room(0.7f);
    scene.sensors.emplace_back();
    GiSettings settings = counted_gather();
    const EmcFrames frames = running(scene, settings);
    hold_still(scene);
    EXPECT_FALSE(frames.next(scene, settings).on(EmcPass::emission));
    settings.edit<EmcSettings>().gather_endless = true;
    const EmcPlan endless = frames.next(scene, settings);
    EXPECT_TRUE(endless.on(EmcPass::lit_maps) && endless.lit.forget);
    EXPECT_FALSE(endless.on(EmcPass::emission));
    settings.photons /= 2;
    EXPECT_TRUE(frames.next(scene, settings).on(EmcPass::emission));
}

// A change is due until what is made from it has been made: also after frames without light, or sensors.
TEST(EmcPlan, WhatWasMissedIsDueLater) {
    FrameScene scene = lit_room(0.7f);
    const GiSettings settings = counted_gather();
    EmcFrames frames = running(scene, settings);
    hold_still(scene);
    frames.run(scene, settings);
    scene.sensors.emplace_back();
    EXPECT_TRUE(frames.run(scene, settings).on(EmcPass::emission)) << "nobody counted any";
    EXPECT_FALSE(frames.run(scene, settings).on(EmcPass::emission));

    FrameScene unlit = scene;
    unlit.lights.clear();
    ++version_of(frames.frame.inputs, EmcInput::sight);
    EXPECT_EQ(frames.run(unlit, settings).bounces, 0);
    EXPECT_EQ(frames.next(scene, settings).why(EmcPass::selection), EmcReason::camera_is_elsewhere);
}

// Endless reflections are modelled where a second one is worth it, whatever gi.bounces says.
TEST(EmcPlan, DarkSurfacesEndEndlessReflections) {
    GiSettings settings;
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    settings.bounces = 1;
    FrameScene bright = lit_room(0.7f), dark = lit_room(0.03f);
    EXPECT_TRUE(first_plan_of(bright, settings).lit.shoot);
    EXPECT_EQ(first_plan_of(bright, settings).lit_bounces, 4);
    EXPECT_FALSE(first_plan_of(dark, settings).lit.shoot);
    hold_still(bright);
    hold_still(dark);
    EXPECT_EQ(settled(bright, settings).next(bright, settings).why(EmcPass::lit_maps),
              EmcReason::light_goes_on);
    EXPECT_FALSE(settled(dark, settings).next(dark, settings).on(EmcPass::lit_maps));
}

}  // namespace emc_plan_test
}  // namespace lanthorn::gi
