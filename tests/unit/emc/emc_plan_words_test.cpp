// What is said of a frame's passes.
#include "gi_module/techniques/emc/emc_plan.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "lanthorn/emc/emc_settings.h"
#include "tests/unit/emc/emc_plan_scenes.h"

namespace lanthorn::gi {
namespace emc_plan_test {

using test::by_splats;
using test::EmcFrames;
using test::first_plan_of;
using test::hold_still;
using test::lit_room;
using test::running;

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

TEST(EmcPlan, JsonIsAListOfPasses) {
    const std::string json = plan_json(first_emc_plan(lit_room(0.7f), {}));
    EXPECT_EQ(json.front(), '[');
    EXPECT_NE(json.find("\"pass\":\"emission\""), std::string::npos);
}

}  // namespace emc_plan_test
}  // namespace lanthorn::gi
