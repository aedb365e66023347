// Playing a clip: forwards, backwards, once, round and round.
#include "tools/editor/window/timeline_shown.h"

#include <gtest/gtest.h>

namespace lanthorn::edit_window {
namespace {

TimelineShown of_two_seconds() {
    TimelineShown line;
    line.clips = {{"walk", "walk", 2, 30, {}, {0, 1, 2}}};
    line.starts_with = "walk";
    return line;
}

TEST(Timeline, PlaysRoundAndRound) {
    TimelineShown line = of_two_seconds();
    line.play(true, 10);
    line.play_on(11.5);
    EXPECT_NEAR(line.second(), 1.5, 1e-9);
    line.play_on(12.5);
    EXPECT_NEAR(line.second(), 0.5, 1e-9);
    line.loop = LoopMode::ping_pong;
    EXPECT_NEAR(line.second(), 1.5, 1e-9);
    line.play(false, 13);
    line.play_on(20);
    EXPECT_NEAR(line.second(), 1.5, 1e-9);
}

TEST(Timeline, StopsAtTheEndOfWhatPlaysOnceAndBeginsAgainThere) {
    TimelineShown line = of_two_seconds();
    line.loop = LoopMode::once;
    line.speed = 2;
    line.play(true, 0);
    line.play_on(5);
    EXPECT_FALSE(line.playing);
    EXPECT_EQ(line.second(), 2);
    line.play(true, 6);
    EXPECT_EQ(line.second(), 0);
    line.speed = -1;
    line.play(true, 7);  // backwards from the beginning: from the end
    EXPECT_EQ(line.second(), 2);
    line.play_on(8);
    EXPECT_NEAR(line.second(), 1, 1e-9);
}

TEST(Timeline, OfNoClipDoesNothing) {
    TimelineShown line;
    line.play(true, 0);
    EXPECT_FALSE(line.playing);
    line.play_on(1);
    line.go_to(3);
    EXPECT_EQ(line.second(), 0);
    TimelineShown none = of_two_seconds();
    none.clip = "none";
    EXPECT_EQ(none.shown(), nullptr);
}

}  // namespace
}  // namespace lanthorn::edit_window
