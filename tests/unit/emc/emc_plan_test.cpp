#include "gi_module/techniques/emc/emc_plan.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "gi_module/shared/plan_rules.h"
#include "gi_module/techniques/emc/splat/accumulation.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/unit/emc/emc_frames.h"

namespace lanthorn::gi {
namespace emc_plan_test {

using test::EmcFrames;
using test::first_plan_of;
using test::running;

static_assert(std::is_trivially_copyable_v<EmcPlan>, "a frame that nobody prints makes no words");

FrameScene lit_room(float albedo) {
    auto assets = std::make_shared<SceneAssets>();
    assets->meshes.emplace_back();
    Material material;
    material.base_colour = vec4(vec3(albedo), 1);
    material.metallic = 0;
    material.specular = 0;
    assets->materials.push_back(material);
    FrameScene scene;
    scene.assets = assets;
    scene.instances.emplace_back();
    scene.lights.emplace_back();
    return scene;
}

void hold_still(FrameScene& scene) {
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
}

GiSettings by_splats() {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    return settings;
}

// gi.bounces reflections, by rays: endless ones go on for some frames.
GiSettings counted_gather() {
    GiSettings settings;
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

// A still picture all of whose rays are in.
EmcFrames settled(const FrameScene& scene, const GiSettings& settings) {
    EmcFrames frames = running(scene, settings);
    frames.kept.texel_frames = frames.kept.point_frames = 16;
    return frames;
}

TEST(EmcPlan, FirstFrameDoesEverything) {
    const EmcPlan plan = first_plan_of(lit_room(0.7f), by_splats());
    for (const EmcPass pass : {EmcPass::selection, EmcPass::environment_maps, EmcPass::emission,
                               EmcPass::bounces, EmcPass::splats, EmcPass::upsampling}) {
        EXPECT_TRUE(plan.on(pass)) << static_cast<int>(pass);
    }
    EXPECT_FALSE(plan.on(EmcPass::progressive_update));
    EXPECT_EQ(plan.bounces, 2);
}

TEST(EmcPlan, AStillSceneCostsNothing) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    const EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_FALSE(plan.on(EmcPass::selection) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::environment_maps) || plan.on(EmcPass::emission) ||
                 plan.on(EmcPass::splats));
}

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
    EXPECT_TRUE(frames.next(scene, settings).lit.look);

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

TEST(EmcPlan, AStillPictureIsRefinedUpToItsPasses) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings = by_splats();
    settings.accumulate = 4;
    EmcFrames frames = running(scene, settings);
    for (int passes = 1; passes <= 5; ++passes) {
        frames.kept.passes = passes;
        const EmcPlan plan = frames.next(scene, settings);
        EXPECT_EQ(plan.on(EmcPass::emission) && plan.on(EmcPass::splats) && plan.on(EmcPass::accumulation),
                  passes < 4)
            << passes;
        EXPECT_EQ(plan.pass, passes < 4 ? passes : 0);
        EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::progressive_update) ||
                     plan.on(EmcPass::selection));
    }
    // Another view begins with the first photons again, since those at hand are of a later pass.
    scene.changes.camera = true;
    const EmcPlan plan = frames.next(scene, settings);
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_EQ(plan.pass, 0);
}

TEST(EmcPlan, SplatsShrinkByTheRecurrenceOfProgressivePhotonMapping) {
    double squared = 1;
    for (int pass = 0; pass < 1000; ++pass) {
        const auto radius = static_cast<double>(pass_radius(pass));
        EXPECT_NEAR(radius * radius, squared, 1e-5 * squared) << static_cast<int>(pass);
        squared *= (pass + 1 + 2.0 / 3.0) / (pass + 2);
    }
}

TEST(EmcPlan, ACameraMoveOnlyGathers) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.camera = true;
    const EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::emission) || plan.on(EmcPass::environment_maps) ||
                 plan.on(EmcPass::progressive_update));
}

TEST(EmcPlan, ALightMoveTracesWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.lights = true;
    const EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::selection));
}

// It was overlooked while a still picture was refined: the mean was of two lights.
TEST(EmcPlan, OtherLightMapsBeginAStillPictureAnew) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings = by_splats();
    settings.accumulate = 4;
    EmcFrames frames = running(scene, settings);
    EXPECT_EQ(frames.next(scene, settings).pass, 1);
    ++version_of(frames.frame.inputs, EmcInput::light_maps);
    const EmcPlan plan = frames.next(scene, settings);
    EXPECT_EQ(plan.why(EmcPass::emission), EmcReason::light_maps_changed);
    EXPECT_EQ(plan.pass, 0);
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

// Every change of assets chose all maps anew.
TEST(EmcPlan, AnEditedColourRelightsAndKeepsTheMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;
    scene.changes.materials = {0};
    scene.changes.painted = {0};
    EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::selection) ||
                 plan.on(EmcPass::progressive_update) || plan.on(EmcPass::coverage));
    EXPECT_EQ(plan.why(EmcPass::environment_maps), EmcReason::colours_are_looked_up);
    EXPECT_EQ(plan.why(EmcPass::emission), EmcReason::paint_changed);
    scene.changes.pattern = true;
    plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::environment_maps) && plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::selection) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::coverage));
    EXPECT_EQ(plan.why(EmcPass::environment_maps), EmcReason::pattern_changed);
}

TEST(EmcPlan, ALampThatFlickersRelightsWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = scene.changes.emission = true;
    const EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::selection));
    EXPECT_EQ(plan.why(EmcPass::emission), EmcReason::emission_changed);
}

TEST(EmcPlan, WhatOnlyThePictureShowsOfAMaterialTracesNothing) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;  // its roughness
    EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_FALSE(plan.on(EmcPass::emission) || plan.on(EmcPass::splats) ||
                 plan.on(EmcPass::environment_maps));
    scene.changes.relief = true;  // its normal map
    plan = running(scene, by_splats()).next(scene, by_splats());
    EXPECT_TRUE(plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::emission) || plan.on(EmcPass::environment_maps));
}

TEST(EmcPlan, MapsAreChosenAnewForAnotherSceneAndForOneThatOutgrowsThem) {
    FrameScene scene = lit_room(0.7f);
    scene.instances[0].bounds = {vec3(0), vec3(1)};
    scene.instances.push_back(scene.instances[0]);
    hold_still(scene);
    scene.changes.geometry = true;
    scene.changes.arrived = {1};
    EmcFrames frames = running(scene, by_splats());
    frames.kept.chosen_for = {vec3(0), vec3(1)};
    EXPECT_FALSE(frames.next(scene, by_splats()).on(EmcPass::selection)) << "it came where maps already are";
    scene.instances[1].bounds = {vec3(3), vec3(4)};
    EXPECT_TRUE(frames.next(scene, by_splats()).on(EmcPass::selection));
    scene.instances[1].bounds = {vec3(3), vec3(3.1f)};
    EXPECT_FALSE(frames.next(scene, by_splats()).on(EmcPass::selection)) << "a small thing far away";
    scene.changes.replaced = true;
    EXPECT_EQ(frames.next(scene, by_splats()).why(EmcPass::selection), EmcReason::other_scene);
}

TEST(EmcPlan, ARoundOfTheProgressiveUpdateIsInThePlan) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.geometry = true;
    EmcFrames frames = running(scene, by_splats());
    for (int frame = 0; frame < 7; ++frame) {
        const EmcPlan plan = frames.run(scene, by_splats());
        EXPECT_TRUE(plan.on(EmcPass::environment_maps) && plan.on(EmcPass::coverage));
        EXPECT_EQ(plan.update.share, frame % 5) << "a fifth of the candidates a frame";
        EXPECT_EQ(plan.update.ask, frame == 5) << frame;
        EXPECT_EQ(plan.on(EmcPass::progressive_update), frame == 6) << frame;
    }
    frames.kept.centres.forget();
    const EmcPlan chosen = frames.next(scene, by_splats());
    EXPECT_FALSE(chosen.on(EmcPass::coverage) || chosen.update.round);
    EXPECT_EQ(chosen.why(EmcPass::coverage), EmcReason::chosen_anew);
}

TEST(EmcPlan, NothingIsModelledThatTheSceneDoesNotRequire) {
    FrameScene dark = lit_room(0.7f);
    dark.lights.clear();
    EXPECT_EQ(first_plan_of(dark, by_splats()).bounces, 0);
    EXPECT_EQ(first_plan_of(lit_room(0.0f), by_splats()).bounces, 0);
    FrameScene empty = lit_room(0.7f);
    empty.instances.clear();
    EXPECT_EQ(first_plan_of(empty, by_splats()).bounces, 0);
    GiSettings many;
    many.bounces = 8;
    EXPECT_EQ(first_plan_of(lit_room(0.9f), many).bounces, 8);
    EXPECT_EQ(first_plan_of(lit_room(0.1f), many).bounces, 2);  // 0.1^3 is below 1/500
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

TEST(EmcPlan, RoughMetalAndWhatATextureMakesRoughReflectDiffusely) {
    FrameScene scene = lit_room(0.7f);
    const auto bounces_with = [&](const auto& alter) {
        auto assets = std::make_shared<SceneAssets>(*scene.assets);
        assets->materials.edit(0, alter);
        scene.assets = assets;
        return first_plan_of(scene, by_splats()).bounces;
    };
    // Mirrors and glass send no light on evenly, but show what falls on them: one reflection, their own.
    // Rough metal does.
    EXPECT_EQ(bounces_with([](Material& m) {
                  m.metallic = 1;
                  m.roughness = 0.1f;
              }),
              1);
    EXPECT_EQ(bounces_with([](Material& m) { m.metallic_roughness_texture.texture = 0; }), 2);
    EXPECT_EQ(bounces_with([](Material& m) {
                  m.metallic_roughness_texture = {};
                  m.roughness = 0.6f;
              }),
              2);
    EXPECT_EQ(bounces_with([](Material& m) {
                  m.metallic = 0;
                  m.transmission = 1;
              }),
              1);
    EXPECT_EQ(bounces_with([](Material& m) { m.transmission_texture.texture = 0; }), 2);
}

// What the plan says of a pass in words.
PlanEntry entry(const EmcPlan& plan, const GiSettings& settings, std::string_view pass,
                const EmcResults& results = {}) {
    for (const PlanEntry& e : in_words(plan, results, settings).entries) {
        if (e.pass == pass) {
            return e;
        }
    }
    ADD_FAILURE() << pass;
    return {};
}

TEST(EmcPlan, EveryPassSaysWhyItRunsOrNot) {
    FrameScene still = lit_room(0.7f);
    hold_still(still);
    FrameScene dark = lit_room(0.7f);
    dark.lights.clear();
    GiSettings settings = by_splats();
    for (const EmcFinal stage : {EmcFinal::splat, EmcFinal::gather}) {
        settings.edit<EmcSettings>().final_stage = stage;
        for (const EmcPlan& plan :
             {first_plan_of(lit_room(0.7f), settings), running(still, settings).next(still, settings),
              first_plan_of(dark, settings), EmcPlan()}) {
            const GiPlan words = in_words(plan, {}, settings);
            ASSERT_EQ(words.entries.size(), kEmcPasses);
            for (std::size_t i = 0; i < kEmcPasses; ++i) {
                const PlanEntry& e = words.entries[i];
                EXPECT_FALSE(e.why.empty()) << e.pass;
                EXPECT_EQ(e.on, plan.steps[i].on) << e.pass;
                EXPECT_TRUE(e.on || e.size.empty()) << e.pass;
            }
        }
    }
}

// It said 1/16 while a still picture was refined with 1/4, and eight maps where three were drawn.
TEST(EmcPlan, WhatIsPrintedIsWhatRuns) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings = by_splats();
    settings.accumulate = 4;
    EmcFrames frames = running(scene, settings);
    const EmcPlan refining = frames.next(scene, settings);
    EXPECT_EQ(refining.base, SplatBase::quarter);
    EXPECT_EQ(entry(refining, settings, "splats").size, "1/4 of the size");
    EXPECT_EQ(entry(refining, settings, "accumulation").size, "pass 2 of 4");
    scene.changes.camera = true;
    EXPECT_EQ(entry(frames.next(scene, settings), settings, "splats").size, "1/16 of the size");

    const EmcPlan first = first_plan_of(lit_room(0.7f), settings);
    EXPECT_EQ(entry(first, settings, "environment_maps").size, "at most 8 maps x 6 x 128^2");
    EmcResults results;
    results.maps = 3;
    results.faces = 18;
    EXPECT_EQ(entry(first, settings, "environment_maps", results).size, "18 faces of 128^2 in 3 maps");
    EXPECT_EQ(entry(first, settings, "selection", results).size, "40 candidates x 6 x 32^2, 3 maps");

    hold_still(scene);
    settings.edit<EmcSettings>().splat_base = SplatBase::half;
    EXPECT_EQ(frames.next(scene, settings).why(EmcPass::splats), EmcReason::no_image_yet);
}

TEST(EmcPlan, WithoutAMapNothingIsTracedAndTheWordsSayWhy) {
    FrameScene scene = lit_room(0.7f);
    EmcFrames frames = running(scene, by_splats());
    const EmcPlan plan = first_plan_of(scene, by_splats());
    EmcResults results;
    results.no_map = true;
    EXPECT_EQ(in_words(plan, results, by_splats()).bounces, 0);
    EXPECT_TRUE(entry(plan, by_splats(), "selection", results).on) << "it did run";
    for (const char* pass : {"emission", "bounces", "lit_maps", "gather", "splats", "upsampling"}) {
        const PlanEntry e = entry(plan, by_splats(), pass, results);
        EXPECT_FALSE(e.on) << pass;
        EXPECT_EQ(e.why, "no candidate sees the front of a surface: there is no map to trace photons in");
    }
    frames.kept.no_map();
    hold_still(scene);
    EXPECT_TRUE(frames.next(scene, by_splats()).on(EmcPass::selection)) << "it is tried again";
}

TEST(EmcPlan, AnExchangedMapIsInTheWords) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    const EmcPlan plan = running(scene, by_splats()).next(scene, by_splats());
    EmcResults results;
    EXPECT_FALSE(entry(plan, by_splats(), "environment_maps", results).on);
    results.exchanged = true;
    EXPECT_EQ(entry(plan, by_splats(), "environment_maps", results).why,
              "a map has been exchanged: the new one");
}

// Each switch of gi.plan makes work that the scene does not require, and says so; one that does not would
// measure nothing.
TEST(EmcPlan, ARuleThatIsOffLeavesNothingOut) {
    FrameScene scene = lit_room(0.02f);
    GiSettings settings = counted_gather();
    const auto without = [&](bool PlanRules::*rule) {
        GiSettings off = settings;
        off.edit<PlanRules>().*rule = false;
        EmcFrames frames = settled(scene, off);
        hold_still(scene);
        return frames.next(scene, off);
    };
    const EmcPlan maps = without(&PlanRules::maps);
    EXPECT_TRUE(maps.redraw_all && maps.on(EmcPass::environment_maps));
    EXPECT_EQ(maps.why(EmcPass::environment_maps), EmcReason::rule_is_off);
    EXPECT_FALSE(maps.lit.look || maps.on(EmcPass::gather)) << "they show what they did";
    const EmcPlan light = without(&PlanRules::light);
    EXPECT_TRUE(light.lit.light && light.lit.light_all && light.on(EmcPass::lit_maps));
    EXPECT_EQ(light.why(EmcPass::lit_maps), EmcReason::rule_is_off);
    EXPECT_FALSE(light.lit.shoot || light.on(EmcPass::environment_maps));
    const EmcPlan picture = without(&PlanRules::picture);
    EXPECT_TRUE(picture.on(EmcPass::gather) && picture.on(EmcPass::filter));
    EXPECT_EQ(picture.why(EmcPass::gather), EmcReason::rule_is_off);
    EXPECT_FALSE(picture.gather.shoot || picture.gather.points || picture.on(EmcPass::lit_maps));
    EXPECT_TRUE(without(&PlanRules::rounds).round_due);
    EXPECT_EQ(without(&PlanRules::bounces).bounces, settings.bounces);
    EXPECT_EQ(without(&PlanRules::count).bounces, 1) << "and its own alone";
    EXPECT_TRUE(without(&PlanRules::mirrors).on(EmcPass::specular));
    EXPECT_FALSE(without(&PlanRules::count).on(EmcPass::specular));
    settings = by_splats();
    EXPECT_TRUE(without(&PlanRules::light).on(EmcPass::bounces));
    EXPECT_TRUE(without(&PlanRules::picture).on(EmcPass::splats));
    EXPECT_FALSE(without(&PlanRules::picture).on(EmcPass::bounces));
}

TEST(EmcPlan, JsonIsAListOfPasses) {
    const std::string json = plan_json(first_emc_plan(lit_room(0.7f), {}));
    EXPECT_EQ(json.front(), '[');
    EXPECT_NE(json.find("\"pass\":\"emission\""), std::string::npos);
}

}  // namespace emc_plan_test
}  // namespace lanthorn::gi
