// Which passes a frame has.
#include "gi_module/techniques/emc/emc_plan.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "gi_module/shared/plan_rules.h"
#include "gi_module/techniques/emc/splat/accumulation.h"
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

static_assert(std::is_trivially_copyable_v<EmcPlan>, "a frame that nobody prints makes no words");

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

}  // namespace emc_plan_test
}  // namespace lanthorn::gi
