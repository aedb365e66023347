// The picture looks at what has woken.
#include "game/level/reveal.h"

#include <gtest/gtest.h>

#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

SceneData two_crystals() {
    scene_generator::Builder b = test_level();
    for (const auto& [name, place] : {std::pair("near", dvec3(-3, 1.2, 1)), {"hidden", dvec3(2, 1.2, 3)}}) {
        const std::uint32_t crystal = b.node(name, scene_generator::looking(place, place + dvec3(-1, 0, 0)));
        b.scene.nodes[crystal].extras = R"({"light_sensor":{},"crystal":{}})";
    }
    return b.scene;
}

void wake(Played& played, const char* name) {
    played.world().get_mut<Crystal>(played.named(name)).awake = true;
}

TEST(Reveal, ShowsWhatWakesForAWhile) {
    Played played(two_crystals());
    played.steps(2);
    Reveal reveal;
    reveal.begin(played.world());
    reveal.watch(played.world());
    EXPECT_FALSE(reveal.showing());
    EXPECT_EQ(reveal.all(), 3);  // and the goal
    wake(played, "near");
    reveal.watch(played.world());
    ASSERT_TRUE(reveal.showing());
    EXPECT_EQ(reveal.awake(), 1);
    EXPECT_EQ(reveal.place(), dvec3(-3, 1.2, 1));
    reveal.pass(Reveal::kEase + Reveal::kHold - 0.1, false);
    EXPECT_TRUE(reveal.showing());
    reveal.pass(0.2, false);
    EXPECT_FALSE(reveal.showing());
    reveal.watch(played.world());  // it is nothing new
    EXPECT_FALSE(reveal.showing());
}

TEST(Reveal, TheLastOneIsLookedAtUntilItIsReleased) {
    Played played(two_crystals());
    played.steps(2);
    Reveal reveal;
    reveal.begin(played.world());
    wake(played, "hidden");
    reveal.watch(played.world());
    reveal.pass(100, true);
    EXPECT_TRUE(reveal.showing());
    reveal.release();
    EXPECT_FALSE(reveal.showing());
}

TEST(Reveal, WhatWasAwakeAsTheLevelBeganIsNotShown) {
    Played played(two_crystals());
    played.steps(2);
    wake(played, "near");
    Reveal reveal;
    reveal.begin(played.world());
    reveal.watch(played.world());
    EXPECT_FALSE(reveal.showing());
}

TEST(Reveal, ChangesNothingInTheLevel) {
    Played played(two_crystals());
    played.steps(2);
    wake(played, "hidden");
    const std::string before = played.playthrough.shown().state();
    Reveal reveal;
    reveal.begin(played.world());
    wake(played, "near");
    const std::string woken = played.playthrough.shown().state();
    reveal.watch(played.world());
    reveal.pass(0.1, false);
    EXPECT_EQ(played.playthrough.shown().state(), woken);
    EXPECT_NE(before, woken);
}

}  // namespace
}  // namespace lanthorn::game
