// What `path` does in a frame, and why.
#include "gi_module/techniques/path/path_plan.h"

#include <gtest/gtest.h>

#include "gi_module/techniques/path/path.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/technique.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

using reference::PathSettings;
using Versions = PathStamps::Versions;

FrameScene lit_floor() {
    return support::scene_of({support::box(vec3(-1), vec3(1), false, 0)}, {support::lambertian(vec3(0.5f))},
                             {support::point_light(vec3(0, 3, 0), 100)}, vec3(0, 2, 5), vec3(0));
}

// All made from `versions`, with so many samples.
PathPictures pictures(const Versions& versions, int spp) {
    PathPictures known;
    known.structure.made(versions);
    known.first_surfaces.made(versions);
    known.paths.made(versions);
    known.spp = spp;
    return known;
}

std::string why(const PathPlan& plan, PathPass pass) {
    return in_words(plan, {}).entries[static_cast<std::size_t>(pass)].why;
}

TEST(PathPlan, TheFirstFrameDoesEverything) {
    const PathPlan plan = make_path_plan(lit_floor(), {}, {}, {});
    EXPECT_TRUE(plan.on(PathPass::acceleration_structure) && plan.on(PathPass::first_surfaces) &&
                plan.on(PathPass::paths));
    EXPECT_TRUE(plan.begins_again);
    EXPECT_EQ(plan.frame_spp, 1);
    EXPECT_EQ(why(plan, PathPass::paths), "there is none yet");
}

TEST(PathPlan, AStillPictureGrowsUpToItsSamples) {
    PathSettings settings;
    settings.spp = 10;
    settings.frame_spp = 4;
    PathPlan plan = make_path_plan(lit_floor(), settings, {}, pictures({}, 4));
    EXPECT_FALSE(plan.begins_again || plan.on(PathPass::acceleration_structure) ||
                 plan.on(PathPass::first_surfaces));
    EXPECT_EQ(plan.from_spp, 4);
    EXPECT_EQ(plan.frame_spp, 4);
    EXPECT_EQ(make_path_plan(lit_floor(), settings, {}, pictures({}, 8)).frame_spp, 2);
    plan = make_path_plan(lit_floor(), settings, {}, pictures({}, 10));
    EXPECT_FALSE(plan.on(PathPass::paths));
    EXPECT_EQ(plan.frame_spp, 0);
    EXPECT_EQ(why(plan, PathPass::paths), "nothing changed, and the mean has path.spp samples");
    settings.spp = 9;  // less than there is: the picture must not know
    EXPECT_TRUE(make_path_plan(lit_floor(), settings, {}, pictures({}, 10)).begins_again);
}

TEST(PathPlan, EndsAtTheNoiseThatIsAskedFor) {
    PathSettings settings;
    settings.spp = 1000;
    settings.frame_spp = 100;
    settings.target_noise = 0.1f;
    PathPictures known = pictures({}, 18);
    known.noise = 0.2;
    // No further than where noise is looked at next.
    EXPECT_EQ(make_path_plan(lit_floor(), settings, {}, known).frame_spp, 2);
    known.noise = 0.05;
    EXPECT_FALSE(make_path_plan(lit_floor(), settings, {}, known).on(PathPass::paths));
}

TEST(PathPlan, WhatChangedSaysWhatIsMadeAnew) {
    const auto changed = [&](PathInput input) {
        Versions now{};
        now[static_cast<std::size_t>(input)] = 1;
        return make_path_plan(lit_floor(), {}, now, pictures({}, 5));
    };
    for (std::size_t input = 0; input < kPathInputs; ++input) {
        const PathPlan plan = changed(static_cast<PathInput>(input));
        EXPECT_TRUE(plan.begins_again) << input;
        EXPECT_EQ(plan.from_spp, 0) << input;
    }
    EXPECT_TRUE(changed(PathInput::geometry).on(PathPass::acceleration_structure));
    EXPECT_FALSE(changed(PathInput::view).on(PathPass::acceleration_structure));
    EXPECT_TRUE(changed(PathInput::view).on(PathPass::first_surfaces));
    EXPECT_FALSE(changed(PathInput::lights).on(PathPass::first_surfaces));
    EXPECT_EQ(why(changed(PathInput::lights), PathPass::paths), "light changed");
}

TEST(PathPlan, ASceneWithoutLightCostsNothing) {
    FrameScene dark = lit_floor();
    dark.lights.clear();
    const PathPlan plan = make_path_plan(dark, {}, {}, {});
    for (std::size_t pass = 0; pass < kPathPasses; ++pass) {
        EXPECT_FALSE(plan.steps[pass].on) << pass;
    }
}

TEST(PathEntry, IsATechniqueLikeTheOthers) {
    const TechniqueKind kind = add_path();
    const TechniqueEntry& entry = technique_entry(kind);
    EXPECT_EQ(entry.name, "path");
    EXPECT_TRUE(entry.is_reference);
    SettingsSchema schema;
    declare_gi_settings(schema);
    Settings settings(schema);
    settings.set_from_text("gi.technique=path");
    settings.set_from_text("path.spp=7");
    settings.set_from_text("path.frame_spp=3");
    settings.set_from_text("path.transport=full");
    const PathSettings own = path_settings(gi_settings(settings));
    EXPECT_EQ(own.spp, 7);
    EXPECT_EQ(own.frame_spp, 3);
    EXPECT_EQ(own.transport, reference::Transport::full);
    GiSettings gi;
    gi.technique = kind;
    EXPECT_EQ(first_plan(lit_floor(), gi).entries.back().pass, "paths");
    EXPECT_NE(make_technique(kind), nullptr);
}

}  // namespace
}  // namespace lanthorn::gi
