#include "lanthorn/gi/plan.h"

#include <gtest/gtest.h>

#include <string>

#include "lanthorn/gi/emc/accumulation.h"

namespace lanthorn::gi {
namespace {

FrameScene lit_room(float albedo) {
    auto assets = std::make_shared<SceneAssets>();
    assets->meshes.emplace_back();
    Material material;
    material.base_colour = vec4(vec3(albedo), 1);
    material.metallic = 0;
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

GiHistory running() {
    GiHistory history;
    history.has_maps = history.has_photons = history.has_image = true;
    history.passes = 1;
    return history;
}

TEST(Plan, FirstFrameDoesEverything) {
    const GiPlan plan = make_plan(lit_room(0.7f), {}, {});
    for (const char* pass :
         {"selection", "environment_maps", "emission", "bounces", "splats", "upsampling"}) {
        EXPECT_TRUE(plan.on(pass)) << pass;
    }
    EXPECT_FALSE(plan.on("progressive_update"));
    EXPECT_EQ(plan.bounces, 2);
    for (const PlanEntry& entry : plan.entries) {
        EXPECT_FALSE(entry.why.empty()) << entry.pass;
    }
}

TEST(Plan, AStillSceneCostsNothing) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    const GiPlan plan = make_plan(scene, {}, running());
    EXPECT_FALSE(plan.select_maps || plan.update_maps || plan.draw_maps || plan.trace || plan.gather);
}

TEST(Plan, TheGatherShootsWhatIsNotRememberedYet) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings;
    settings.emc_final = EmcFinal::gather;
    const GiPlan first = make_plan(scene, settings, {});
    for (const char* pass : {"selection", "environment_maps", "lit_maps", "gather", "filter", "upsampling"}) {
        EXPECT_TRUE(first.on(pass)) << pass;
    }
    EXPECT_FALSE(first.trace || first.on("emission") || first.on("splats"));

    hold_still(scene);
    GiHistory history = running();
    history.has_lit = true;
    history.texel_frames = history.point_frames = 15;
    const GiPlan last = make_plan(scene, settings, history);
    EXPECT_TRUE(last.texel_rays && last.point_rays && last.gather);
    EXPECT_FALSE(last.list_texels || last.light_texels || last.list_points);

    history.texel_frames = history.point_frames = 16;
    const GiPlan still = make_plan(scene, settings, history);
    EXPECT_FALSE(still.texel_rays || still.point_rays || still.gather || still.light_texels);
    scene.changes.lights = true;
    const GiPlan light = make_plan(scene, settings, history);
    EXPECT_TRUE(light.light_texels && light.gather);
    EXPECT_FALSE(light.texel_rays || light.point_rays || light.list_texels || light.list_points);
    scene.changes.lights = false;
    scene.changes.camera = true;
    const GiPlan view = make_plan(scene, settings, history);
    EXPECT_TRUE(view.list_points && view.point_rays);
    EXPECT_FALSE(view.texel_rays || view.light_texels);
    scene.changes.painted = {0};
    EXPECT_TRUE(make_plan(scene, settings, history).list_texels);

    scene.sensors.emplace_back();
    EXPECT_TRUE(make_plan(scene, settings, {}).trace);  // sensors count photons
}

TEST(Plan, AStillPictureIsRefinedUpToItsPasses) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings;
    settings.accumulate = 4;
    GiHistory history = running();
    for (int passes = 1; passes <= 5; ++passes) {
        history.passes = passes;
        const GiPlan plan = make_plan(scene, settings, history);
        EXPECT_EQ(plan.trace && plan.gather && plan.on("accumulation"), passes < 4) << passes;
        EXPECT_EQ(plan.pass, passes < 4 ? passes : 0);
        EXPECT_FALSE(plan.draw_maps || plan.update_maps || plan.select_maps);
    }
    // Another view begins with the first photons again, since those at hand are of a later pass.
    scene.changes.camera = true;
    const GiPlan plan = make_plan(scene, settings, history);
    EXPECT_TRUE(plan.trace && plan.gather);
    EXPECT_EQ(plan.pass, 0);
}

TEST(Plan, SplatsShrinkByTheRecurrenceOfProgressivePhotonMapping) {
    double squared = 1;
    for (int pass = 0; pass < 1000; ++pass) {
        const auto radius = static_cast<double>(pass_radius(pass));
        EXPECT_NEAR(radius * radius, squared, 1e-5 * squared) << pass;
        squared *= (pass + 1 + 2.0 / 3.0) / (pass + 2);
    }
}

TEST(Plan, ACameraMoveOnlyGathers) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.camera = true;
    const GiPlan plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.gather);
    EXPECT_FALSE(plan.trace || plan.draw_maps || plan.update_maps);
}

TEST(Plan, ALightMoveTracesWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.lights = true;
    const GiPlan plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.trace && plan.gather);
    EXPECT_FALSE(plan.draw_maps || plan.update_maps || plan.select_maps);
}

std::string why(const GiPlan& plan, const std::string& pass) {
    for (const PlanEntry& e : plan.entries) {
        if (e.pass == pass) {
            return e.why;
        }
    }
    return {};
}

// Every change of assets chose all maps anew.
TEST(Plan, AnEditedColourRelightsAndKeepsTheMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;
    scene.changes.materials = {0};
    scene.changes.painted = {0};
    GiPlan plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.trace && plan.gather);
    EXPECT_FALSE(plan.draw_maps || plan.select_maps || plan.update_maps || plan.share >= 0);
    EXPECT_EQ(why(plan, "environment_maps"), "a material has another colour, which maps look up: they hold");
    EXPECT_EQ(why(plan, "emission"), "a material reflects otherwise");
    scene.changes.pattern = true;
    plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.draw_maps && plan.trace && plan.gather);
    EXPECT_FALSE(plan.select_maps || plan.update_maps || plan.share >= 0);
    EXPECT_EQ(why(plan, "environment_maps"),
              "a material has another pattern: faces that see it; the centres hold");
}

TEST(Plan, ALampThatFlickersRelightsWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = scene.changes.emission = true;
    const GiPlan plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.trace && plan.gather);
    EXPECT_FALSE(plan.draw_maps || plan.select_maps);
    EXPECT_EQ(why(plan, "emission"), "a material emits otherwise");
}

TEST(Plan, WhatOnlyThePictureShowsOfAMaterialTracesNothing) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;  // its roughness
    GiPlan plan = make_plan(scene, {}, running());
    EXPECT_FALSE(plan.trace || plan.gather || plan.draw_maps);
    scene.changes.relief = true;  // its normal map
    plan = make_plan(scene, {}, running());
    EXPECT_TRUE(plan.gather);
    EXPECT_FALSE(plan.trace || plan.draw_maps);
}

TEST(Plan, MapsAreChosenAnewForAnotherSceneAndForOneThatOutgrowsThem) {
    FrameScene scene = lit_room(0.7f);
    scene.instances[0].bounds = {vec3(0), vec3(1)};
    scene.instances.push_back(scene.instances[0]);
    hold_still(scene);
    scene.changes.geometry = true;
    scene.changes.arrived = {1};
    GiHistory history = running();
    history.chosen_for = {vec3(0), vec3(1)};
    EXPECT_FALSE(make_plan(scene, {}, history).select_maps) << "it came where maps already are";
    scene.instances[1].bounds = {vec3(3), vec3(4)};
    EXPECT_TRUE(make_plan(scene, {}, history).select_maps);
    scene.instances[1].bounds = {vec3(3), vec3(3.1f)};
    EXPECT_FALSE(make_plan(scene, {}, history).select_maps) << "a small thing far away";
    scene.changes.replaced = true;
    EXPECT_EQ(why(make_plan(scene, {}, history), "selection"),
              "nothing of the scene before is left: choose all maps anew");
}

TEST(Plan, ProgressiveUpdateOnceEveryFiveFramesOfMotion) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.geometry = true;
    GiHistory history = running();
    for (int frame = 0; frame < 5; ++frame) {
        history.round = frame;
        const GiPlan plan = make_plan(scene, {}, history);
        EXPECT_TRUE(plan.draw_maps);
        EXPECT_TRUE(plan.on("coverage"));
        EXPECT_EQ(plan.share, frame) << "a fifth of the candidates a frame";
        EXPECT_EQ(plan.shares, 5);
        EXPECT_EQ(plan.update_maps, frame == 4) << frame;
    }
    // Motion that has ended before its update was due is still looked at.
    hold_still(scene);
    history.geometry_pending = true;
    EXPECT_TRUE(make_plan(scene, {}, history).update_maps);
    history.round = 1;
    EXPECT_EQ(make_plan(scene, {}, history).share, 1);
}

TEST(Plan, TheLookOfALongIntervalIsSpreadOverItsLastFrames) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.geometry = true;
    GiSettings settings;
    settings.emc_update_interval = 100;
    GiHistory history = running();
    int share = 0;
    for (int frame = 0; frame < 100; ++frame) {
        history.round = frame;
        const GiPlan plan = make_plan(scene, settings, history);
        EXPECT_EQ(plan.share, frame < 100 - plan.shares ? -1 : share++) << frame;
        EXPECT_EQ(plan.update_maps, frame == 99) << frame;
        EXPECT_EQ(plan.on("coverage"), plan.share >= 0);
    }
    EXPECT_EQ(share, update_shares(settings));
    settings.emc_update_interval = 1;
    history.round = 0;
    const GiPlan plan = make_plan(scene, settings, history);
    EXPECT_TRUE(plan.share == 0 && plan.shares == 1 && plan.update_maps);
}

TEST(Plan, NothingIsModelledThatTheSceneDoesNotRequire) {
    FrameScene dark = lit_room(0.7f);
    dark.lights.clear();
    EXPECT_EQ(make_plan(dark, {}, {}).bounces, 0);
    EXPECT_EQ(make_plan(lit_room(0.0f), {}, {}).bounces, 0);
    FrameScene empty = lit_room(0.7f);
    empty.instances.clear();
    EXPECT_EQ(make_plan(empty, {}, {}).bounces, 0);
    GiSettings many;
    many.bounces = 8;
    EXPECT_EQ(make_plan(lit_room(0.9f), many, {}).bounces, 8);
    EXPECT_EQ(make_plan(lit_room(0.1f), many, {}).bounces, 2);  // 0.1^3 is below 1/500
    GiSettings none;
    none.technique = TechniqueKind::none;
    EXPECT_EQ(make_plan(lit_room(0.7f), none, {}).bounces, 0);
}

TEST(Plan, MetalUnderATextureMayReflectDiffusely) {
    FrameScene scene = lit_room(0.7f);
    const auto bounces_with = [&](const auto& alter) {
        auto assets = std::make_shared<SceneAssets>(*scene.assets);
        assets->materials.edit(0, alter);
        scene.assets = assets;
        return make_plan(scene, {}, {}).bounces;
    };
    EXPECT_EQ(bounces_with([](Material& m) { m.metallic = 1; }), 0);
    EXPECT_EQ(bounces_with([](Material& m) { m.metallic_roughness_texture.texture = 0; }), 2);
    EXPECT_EQ(bounces_with([](Material& m) {
                  m.metallic = 0;
                  m.transmission = 1;
              }),
              0);
    EXPECT_EQ(bounces_with([](Material& m) { m.transmission_texture.texture = 0; }), 2);
}

TEST(Plan, GivingUpTurnsOffWhatNeedsMapsAndSaysWhy) {
    GiPlan plan = make_plan(lit_room(0.7f), {}, {});
    plan.give_up("no map");
    EXPECT_EQ(plan.bounces, 0);
    EXPECT_FALSE(plan.trace || plan.gather);
    EXPECT_TRUE(plan.on("selection")) << "it did run";
    for (const PlanEntry& entry : plan.entries) {
        if (entry.pass == "emission" || entry.pass == "splats") {
            EXPECT_FALSE(entry.on);
            EXPECT_EQ(entry.why, "no map");
        }
    }
}

TEST(Plan, JsonIsAListOfPasses) {
    const std::string json = plan_json(make_plan(lit_room(0.7f), {}, {}));
    EXPECT_EQ(json.front(), '[');
    EXPECT_NE(json.find("\"pass\":\"emission\""), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::gi
