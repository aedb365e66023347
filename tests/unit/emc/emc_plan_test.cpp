#include "gi_module/techniques/emc/emc_plan.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "gi_module/techniques/emc/splat/accumulation.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {
namespace {

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

// gi.bounces reflections: endless ones go on for some frames.
GiSettings counted_gather() {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

EmcHistory running() {
    EmcHistory history;
    history.has_maps = history.has_photons = history.has_image = true;
    history.passes = 1;
    return history;
}

TEST(EmcPlan, FirstFrameDoesEverything) {
    const EmcPlan plan = make_emc_plan(lit_room(0.7f), by_splats(), {});
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
    const EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_FALSE(plan.on(EmcPass::selection) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::environment_maps) || plan.on(EmcPass::emission) ||
                 plan.on(EmcPass::splats));
}

TEST(EmcPlan, TheGatherShootsWhatIsNotRememberedYet) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings = counted_gather();
    const EmcPlan first = make_emc_plan(scene, settings, {});
    for (const EmcPass pass : {EmcPass::selection, EmcPass::environment_maps, EmcPass::lit_maps,
                               EmcPass::gather, EmcPass::filter, EmcPass::upsampling}) {
        EXPECT_TRUE(first.on(pass)) << static_cast<int>(pass);
    }
    EXPECT_FALSE(first.on(EmcPass::emission) || first.on(EmcPass::emission) || first.on(EmcPass::splats));

    hold_still(scene);
    EmcHistory history = running();
    history.has_lit = true;
    history.texel_frames = history.point_frames = 15;
    const EmcPlan last = make_emc_plan(scene, settings, history);
    EXPECT_TRUE(last.texel_rays && last.point_rays && last.on(EmcPass::gather));
    EXPECT_FALSE(last.list_texels || last.light_texels || last.list_points);

    history.texel_frames = history.point_frames = 16;
    const EmcPlan still = make_emc_plan(scene, settings, history);
    EXPECT_FALSE(still.texel_rays || still.point_rays || still.on(EmcPass::gather) || still.light_texels);
    scene.changes.lights = true;
    const EmcPlan light = make_emc_plan(scene, settings, history);
    EXPECT_TRUE(light.light_texels && light.on(EmcPass::gather));
    EXPECT_FALSE(light.texel_rays || light.point_rays || light.list_texels || light.list_points);
    scene.changes.lights = false;
    scene.changes.camera = true;
    const EmcPlan view = make_emc_plan(scene, settings, history);
    EXPECT_TRUE(view.list_points && view.point_rays);
    EXPECT_FALSE(view.texel_rays || view.light_texels);
    scene.changes.painted = {0};
    EXPECT_TRUE(make_emc_plan(scene, settings, history).list_texels);

    scene.sensors.emplace_back();
    EXPECT_TRUE(make_emc_plan(scene, settings, {}).on(EmcPass::emission));  // sensors count photons
}

TEST(EmcPlan, PhotonsLightTheMapsWhereRaysDoNot) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings = counted_gather();
    settings.edit<EmcSettings>().gather_source = GatherSource::photons;
    const EmcPlan first = make_emc_plan(scene, settings, {});
    EXPECT_TRUE(first.by_photons && first.on(EmcPass::lit_photons) && first.on(EmcPass::lit_maps));
    EXPECT_FALSE(first.texel_rays || first.on(EmcPass::emission));
    EXPECT_EQ(first.photon_bounces, settings.bounces - 1) << "the picture sees them reflected once more";

    hold_still(scene);
    EmcHistory history = running();
    history.has_lit = history.has_lit_photons = true;
    history.point_frames = 16;
    history.light_frames = 15;
    const EmcPlan last = make_emc_plan(scene, settings, history);
    EXPECT_TRUE(last.on(EmcPass::lit_photons) && last.on(EmcPass::lit_maps) && last.on(EmcPass::gather));
    history.light_frames = 16;
    const EmcPlan still = make_emc_plan(scene, settings, history);
    EXPECT_FALSE(still.on(EmcPass::lit_photons) || still.on(EmcPass::lit_maps) || still.on(EmcPass::gather));
    EXPECT_EQ(still.why(EmcPass::lit_photons), EmcReason::photons_are_in);
    history.has_lit_photons = false;
    EXPECT_EQ(make_emc_plan(scene, settings, history).why(EmcPass::lit_photons),
              EmcReason::texels_count_photons);
    history.has_lit_photons = true;
    scene.changes.lights = true;
    EXPECT_TRUE(make_emc_plan(scene, settings, history).on(EmcPass::lit_photons));

    settings.edit<EmcSettings>().gather_endless = true;
    EXPECT_EQ(make_emc_plan(scene, settings, {}).photon_bounces, 4);
    settings.edit<EmcSettings>().gather_endless = false;
    settings.bounces = 1;
    EXPECT_EQ(make_emc_plan(scene, settings, {}).why(EmcPass::lit_photons), EmcReason::one_reflection);
    settings.bounces = 2;
    scene.sky.emplace();
    const EmcPlan sky = make_emc_plan(scene, settings, {});
    EXPECT_TRUE(sky.texel_rays);
    EXPECT_FALSE(sky.by_photons);
    EXPECT_EQ(sky.why(EmcPass::lit_photons), EmcReason::sky_by_rays);
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    EXPECT_EQ(make_emc_plan(scene, settings, {}).why(EmcPass::lit_photons), EmcReason::texels_have_rays);
}

TEST(EmcPlan, WhatIsKnownOfSurfacesHoldsWhileItIsDark) {
    FrameScene scene = lit_room(0.7f);
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    EmcHistory before = running();
    before.has_lit = true;
    before.texel_frames = before.point_frames = 16;
    hold_still(scene);
    scene.changes.lights = true;

    EmcHistory dark = before;
    dark.darken(scene.changes);
    EXPECT_FALSE(dark.has_photons);
    // Whatever is said to have changed when there is light again.
    scene.changes.lights = false;
    const EmcPlan light = make_emc_plan(scene, settings, dark);
    EXPECT_TRUE(light.light_texels && light.on(EmcPass::gather));
    EXPECT_FALSE(light.on(EmcPass::selection) || light.list_texels || light.texel_rays || light.list_points ||
                 light.point_rays);
    EXPECT_TRUE(make_emc_plan(scene, by_splats(), dark).on(EmcPass::emission));

    scene.changes.camera = true;
    dark.darken(scene.changes);
    scene.changes.camera = false;
    const EmcPlan view = make_emc_plan(scene, settings, dark);
    EXPECT_TRUE(view.list_points);
    EXPECT_FALSE(view.on(EmcPass::selection) || view.list_texels);

    for (const auto& alter :
         {+[](SceneChanges& c) { c.geometry = true; }, +[](SceneChanges& c) { c.pattern = true; },
          +[](SceneChanges& c) { c.painted = {0}; }}) {
        EmcHistory other = before;
        SceneChanges changes = scene.changes;
        alter(changes);
        other.darken(changes);
        EXPECT_TRUE(make_emc_plan(scene, settings, other).on(EmcPass::selection));
    }
}

TEST(EmcPlan, AGatheredPictureIsRefinedOnceAllIsRemembered) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    GiSettings settings = counted_gather();
    EmcHistory history = running();
    history.has_lit = true;
    history.texel_frames = history.point_frames = 16;
    history.passes = 1;
    EXPECT_EQ(make_emc_plan(scene, settings, history).why(EmcPass::accumulation), EmcReason::one_pass_is_all);
    settings.accumulate = 4;
    for (int passes = 1; passes <= 5; ++passes) {
        history.passes = passes;
        const EmcPlan plan = make_emc_plan(scene, settings, history);
        EXPECT_EQ(plan.on(EmcPass::accumulation), passes < 4) << passes;
        EXPECT_EQ(plan.pass, passes < 4 ? passes : 0);
        EXPECT_FALSE(plan.on(EmcPass::gather) || plan.on(EmcPass::lit_maps));
    }
    history.passes = 1;
    history.point_frames = 15;
    const EmcPlan early = make_emc_plan(scene, settings, history);
    EXPECT_FALSE(early.on(EmcPass::accumulation));
    EXPECT_EQ(early.why(EmcPass::accumulation), EmcReason::rays_first);
    history.point_frames = 16;
    scene.changes.lights = true;
    EXPECT_FALSE(make_emc_plan(scene, settings, history).on(EmcPass::accumulation));
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
    EmcHistory history = running();
    for (int passes = 1; passes <= 5; ++passes) {
        history.passes = passes;
        const EmcPlan plan = make_emc_plan(scene, settings, history);
        EXPECT_EQ(plan.on(EmcPass::emission) && plan.on(EmcPass::splats) && plan.on(EmcPass::accumulation),
                  passes < 4)
            << passes;
        EXPECT_EQ(plan.pass, passes < 4 ? passes : 0);
        EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::progressive_update) ||
                     plan.on(EmcPass::selection));
    }
    // Another view begins with the first photons again, since those at hand are of a later pass.
    scene.changes.camera = true;
    const EmcPlan plan = make_emc_plan(scene, settings, history);
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
    const EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_TRUE(plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::emission) || plan.on(EmcPass::environment_maps) ||
                 plan.on(EmcPass::progressive_update));
}

TEST(EmcPlan, ALightMoveTracesWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.lights = true;
    const EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::selection));
}

// Every change of assets chose all maps anew.
TEST(EmcPlan, AnEditedColourRelightsAndKeepsTheMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;
    scene.changes.materials = {0};
    scene.changes.painted = {0};
    EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::selection) ||
                 plan.on(EmcPass::progressive_update) || plan.on(EmcPass::coverage));
    EXPECT_EQ(plan.why(EmcPass::environment_maps), EmcReason::colours_are_looked_up);
    EXPECT_EQ(plan.why(EmcPass::emission), EmcReason::paint_changed);
    scene.changes.pattern = true;
    plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_TRUE(plan.on(EmcPass::environment_maps) && plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::selection) || plan.on(EmcPass::progressive_update) ||
                 plan.on(EmcPass::coverage));
    EXPECT_EQ(plan.why(EmcPass::environment_maps), EmcReason::pattern_changed);
}

TEST(EmcPlan, ALampThatFlickersRelightsWithoutDrawingMaps) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = scene.changes.emission = true;
    const EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_TRUE(plan.on(EmcPass::emission) && plan.on(EmcPass::splats));
    EXPECT_FALSE(plan.on(EmcPass::environment_maps) || plan.on(EmcPass::selection));
    EXPECT_EQ(plan.why(EmcPass::emission), EmcReason::emission_changed);
}

TEST(EmcPlan, WhatOnlyThePictureShowsOfAMaterialTracesNothing) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.assets = true;  // its roughness
    EmcPlan plan = make_emc_plan(scene, by_splats(), running());
    EXPECT_FALSE(plan.on(EmcPass::emission) || plan.on(EmcPass::splats) ||
                 plan.on(EmcPass::environment_maps));
    scene.changes.relief = true;  // its normal map
    plan = make_emc_plan(scene, by_splats(), running());
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
    EmcHistory history = running();
    history.chosen_for = {vec3(0), vec3(1)};
    EXPECT_FALSE(make_emc_plan(scene, by_splats(), history).on(EmcPass::selection))
        << "it came where maps already are";
    scene.instances[1].bounds = {vec3(3), vec3(4)};
    EXPECT_TRUE(make_emc_plan(scene, by_splats(), history).on(EmcPass::selection));
    scene.instances[1].bounds = {vec3(3), vec3(3.1f)};
    EXPECT_FALSE(make_emc_plan(scene, by_splats(), history).on(EmcPass::selection))
        << "a small thing far away";
    scene.changes.replaced = true;
    EXPECT_EQ(make_emc_plan(scene, by_splats(), history).why(EmcPass::selection), EmcReason::other_scene);
}

TEST(EmcPlan, ARoundOfTheProgressiveUpdateIsInThePlan) {
    FrameScene scene = lit_room(0.7f);
    hold_still(scene);
    scene.changes.geometry = true;
    EmcHistory history = running();
    for (int frame = 0; frame < 7; ++frame) {
        const EmcPlan plan = make_emc_plan(scene, by_splats(), history);
        EXPECT_TRUE(plan.on(EmcPass::environment_maps) && plan.on(EmcPass::coverage));
        EXPECT_EQ(plan.update.share, frame % 5) << "a fifth of the candidates a frame";
        EXPECT_EQ(plan.update.ask, frame == 5) << frame;
        EXPECT_EQ(plan.on(EmcPass::progressive_update), frame == 6) << frame;
        history.update.advance(true, false, plan.update);
    }
    history.has_maps = false;
    const EmcPlan chosen = make_emc_plan(scene, by_splats(), history);
    EXPECT_FALSE(chosen.on(EmcPass::coverage) || chosen.update.round);
    EXPECT_EQ(chosen.why(EmcPass::coverage), EmcReason::chosen_anew);
}

TEST(EmcPlan, NothingIsModelledThatTheSceneDoesNotRequire) {
    FrameScene dark = lit_room(0.7f);
    dark.lights.clear();
    EXPECT_EQ(make_emc_plan(dark, by_splats(), {}).bounces, 0);
    EXPECT_EQ(make_emc_plan(lit_room(0.0f), by_splats(), {}).bounces, 0);
    FrameScene empty = lit_room(0.7f);
    empty.instances.clear();
    EXPECT_EQ(make_emc_plan(empty, by_splats(), {}).bounces, 0);
    GiSettings many;
    many.bounces = 8;
    EXPECT_EQ(make_emc_plan(lit_room(0.9f), many, {}).bounces, 8);
    EXPECT_EQ(make_emc_plan(lit_room(0.1f), many, {}).bounces, 2);  // 0.1^3 is below 1/500
}

// Endless reflections are modelled where a second one is worth it, whatever gi.bounces says.
TEST(EmcPlan, DarkSurfacesEndEndlessReflections) {
    GiSettings settings;
    settings.bounces = 1;
    FrameScene bright = lit_room(0.7f), dark = lit_room(0.03f);
    EXPECT_TRUE(make_emc_plan(bright, settings, {}).texel_rays);
    EXPECT_EQ(make_emc_plan(bright, settings, {}).lit_bounces, 4);
    EXPECT_FALSE(make_emc_plan(dark, settings, {}).texel_rays);
    hold_still(bright);
    hold_still(dark);
    EmcHistory history = running();
    history.has_lit = true;
    history.texel_frames = history.point_frames = 16;
    EXPECT_EQ(make_emc_plan(bright, settings, history).why(EmcPass::lit_maps), EmcReason::light_goes_on);
    EXPECT_FALSE(make_emc_plan(dark, settings, history).on(EmcPass::lit_maps));
}

TEST(EmcPlan, RoughMetalAndWhatATextureMakesRoughReflectDiffusely) {
    FrameScene scene = lit_room(0.7f);
    const auto bounces_with = [&](const auto& alter) {
        auto assets = std::make_shared<SceneAssets>(*scene.assets);
        assets->materials.edit(0, alter);
        scene.assets = assets;
        return make_emc_plan(scene, by_splats(), {}).bounces;
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

TEST(EmcPlan, GivingUpTurnsOffWhatNeedsMapsAndSaysWhy) {
    EmcPlan plan = make_emc_plan(lit_room(0.7f), by_splats(), {});
    plan.give_up();
    EXPECT_EQ(plan.bounces, 0);
    EXPECT_TRUE(plan.on(EmcPass::selection)) << "it did run";
    for (const EmcPass pass : {EmcPass::emission, EmcPass::bounces, EmcPass::lit_maps, EmcPass::gather,
                               EmcPass::splats, EmcPass::upsampling}) {
        EXPECT_FALSE(plan.on(pass)) << static_cast<int>(pass);
        EXPECT_EQ(plan.why(pass), EmcReason::no_map);
    }
}

// What the plan says of a pass in words.
PlanEntry entry(const EmcPlan& plan, const GiSettings& settings, std::string_view pass) {
    for (const PlanEntry& e : in_words(plan, settings).entries) {
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
             {make_emc_plan(lit_room(0.7f), settings, {}), make_emc_plan(still, settings, running()),
              make_emc_plan(dark, settings, {}), EmcPlan()}) {
            const GiPlan words = in_words(plan, settings);
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
    EmcHistory history = running();
    const EmcPlan refining = make_emc_plan(scene, settings, history);
    EXPECT_EQ(refining.base, SplatBase::quarter);
    EXPECT_EQ(entry(refining, settings, "splats").size, "1/4 of the size");
    EXPECT_EQ(entry(refining, settings, "accumulation").size, "pass 2 of 4");
    scene.changes.camera = true;
    EXPECT_EQ(entry(make_emc_plan(scene, settings, history), settings, "splats").size, "1/16 of the size");

    EmcPlan first = make_emc_plan(lit_room(0.7f), settings, {});
    EXPECT_EQ(entry(first, settings, "environment_maps").size, "at most 8 maps x 6 x 128^2");
    first.maps = 3;
    first.faces = 18;
    EXPECT_EQ(entry(first, settings, "environment_maps").size, "18 faces of 128^2 in 3 maps");
    EXPECT_EQ(entry(first, settings, "selection").size, "40 candidates x 6 x 32^2, 3 maps");

    history.has_image = false;  // another gi.emc.splat.base
    hold_still(scene);
    EXPECT_EQ(make_emc_plan(scene, settings, history).why(EmcPass::splats), EmcReason::no_image_yet);
}

TEST(EmcPlan, JsonIsAListOfPasses) {
    const std::string json = plan_json(first_emc_plan(lit_room(0.7f), {}));
    EXPECT_EQ(json.front(), '[');
    EXPECT_NE(json.find("\"pass\":\"emission\""), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::gi
