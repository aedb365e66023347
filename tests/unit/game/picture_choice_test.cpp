// What a player chooses of the picture, and what the command line asks for.
#include "game/presentation/picture_choice.h"

#include <gtest/gtest.h>

#include "game/rules/lingering.h"

namespace lanthorn::game {
namespace {

TEST(PictureChoice, UnlessToldOtherwiseIsForTheMachine) {
    const PictureChoice on_cpu(Options{}, {}, true);
    EXPECT_EQ(on_cpu.preset(), "low");
    EXPECT_EQ(on_cpu.size(), ivec2(640, 360));
    const PictureChoice on_gpu(Options{}, {}, false);
    EXPECT_EQ(on_gpu.preset(), "medium");
    EXPECT_EQ(on_gpu.size(), ivec2(1280, 720));
}

TEST(PictureChoice, TheCommandLineHoldsUntilThePlayerChooses) {
    Options options;
    options.size = ivec2(320, 200);
    options.preset = "high";
    Preferences kept;
    kept.picture = ivec2(800, 600);
    kept.preset = "ultra";
    PictureChoice choice(options, kept, true);
    EXPECT_EQ(choice.size(), ivec2(320, 200));
    EXPECT_EQ(choice.preset(), "high");

    Preferences chosen = kept;
    chosen.preset = "high";  // as she sees it
    chosen.mouse = 2;
    choice.choose(chosen);
    EXPECT_EQ(choice.size(), ivec2(320, 200));
    EXPECT_EQ(choice.preset(), "high");
    EXPECT_EQ(choice.preferences().preset, "ultra") << "what the command line asks for is not kept";
    EXPECT_EQ(choice.preferences().mouse, 2);

    chosen.picture = ivec2(1024, 768);
    choice.choose(chosen);
    EXPECT_EQ(choice.size(), ivec2(1024, 768));
    EXPECT_EQ(choice.preset(), "high");

    chosen.preset = "medium";
    choice.choose(chosen);
    EXPECT_EQ(choice.preset(), "medium");
    EXPECT_EQ(choice.preferences().preset, "medium");
}

TEST(PictureChoice, OnTheCpuAFrameHasATimeUnlessThePictureIsChosen) {
    EXPECT_EQ(PictureChoice(Options{}, {}, false).frame_budget(), 0);
    EXPECT_EQ(PictureChoice(Options{}, {}, true).frame_budget(), shell::kFrameMsOnCpu);
    Options size, preset;
    size.size = ivec2(640, 360);
    preset.preset = "low";
    EXPECT_EQ(PictureChoice(size, {}, true).frame_budget(), 0);
    EXPECT_EQ(PictureChoice(preset, {}, true).frame_budget(), 0);
    Preferences large, good, hurried;
    large.picture = ivec2(640, 360);
    good.preset = "low";
    hurried.frame_budget = 50;
    EXPECT_EQ(PictureChoice(Options{}, large, true).frame_budget(), 0);
    EXPECT_EQ(PictureChoice(Options{}, good, true).frame_budget(), 0);
    EXPECT_EQ(PictureChoice(size, hurried, true).frame_budget(), 50);
}

// What she sees on the options screen is not kept as if she had chosen it.
TEST(PictureChoice, ABudgetThatSheOnlySeesIsNotHerChoice) {
    PictureChoice choice(Options{}, {}, true);
    Preferences seen;
    seen.preset = "low";
    seen.frame_budget = shell::kFrameMsOnCpu;
    seen.mouse = 2;
    choice.choose(seen);
    EXPECT_FALSE(choice.preferences().frame_budget);
    EXPECT_EQ(choice.frame_budget(), shell::kFrameMsOnCpu);
    seen.frame_budget = 0;
    choice.choose(seen);
    EXPECT_EQ(choice.preferences().frame_budget, 0.0);
    EXPECT_EQ(choice.frame_budget(), 0);
}

TEST(Lingering, PassesWhatHasHeldForLong) {
    Lingering lingering;
    EXPECT_FALSE(lingering.pass(true, 2));
    EXPECT_FALSE(lingering.pass(true, 1));
    EXPECT_TRUE(lingering.pass(true, 0.5));
    EXPECT_FALSE(lingering.pass(false, 1));
    EXPECT_FALSE(lingering.pass(true, 2.5)) << "it begins anew";
    lingering.forget();
    EXPECT_FALSE(lingering.pass(true, 2.5));
}

}  // namespace
}  // namespace lanthorn::game
