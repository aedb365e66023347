#include "lanthorn/animation/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn {
namespace {

double at(LoopMode mode, double time) {
    return clip_moment(mode, time, 2).time;
}

TEST(Playback, OnceStopsAtItsEnds) {
    EXPECT_EQ(at(LoopMode::once, -1), 0);
    EXPECT_EQ(at(LoopMode::once, 1.5), 1.5);
    EXPECT_EQ(at(LoopMode::once, 2), 2);
    EXPECT_EQ(at(LoopMode::once, 7), 2);
}

TEST(Playback, LoopStartsAgainAtItsEnd) {
    EXPECT_EQ(at(LoopMode::loop, 0), 0);
    EXPECT_EQ(at(LoopMode::loop, 2), 0);
    EXPECT_EQ(at(LoopMode::loop, 5), 1);
    EXPECT_EQ(at(LoopMode::loop, -0.5), 1.5);
    EXPECT_EQ(clip_moment(LoopMode::loop, 5, 2).rounds, 2);
    EXPECT_EQ(clip_moment(LoopMode::loop, 4, 2).rounds, 2);
    EXPECT_EQ(clip_moment(LoopMode::loop, -0.5, 2).rounds, -1);
    EXPECT_EQ(clip_moment(LoopMode::loop, 1.999, 2).rounds, 0);
}

TEST(Playback, PingPongTurnsAtBothEnds) {
    EXPECT_EQ(at(LoopMode::ping_pong, 1.5), 1.5);
    EXPECT_EQ(at(LoopMode::ping_pong, 2), 2);
    EXPECT_EQ(at(LoopMode::ping_pong, 2.5), 1.5);
    EXPECT_EQ(at(LoopMode::ping_pong, 4), 0);
    EXPECT_EQ(at(LoopMode::ping_pong, 4.5), 0.5);
    EXPECT_EQ(at(LoopMode::ping_pong, -0.5), 0.5);
}

TEST(Playback, AClipWithoutDurationStandsStill) {
    for (const LoopMode mode : {LoopMode::once, LoopMode::loop, LoopMode::ping_pong}) {
        EXPECT_EQ(clip_moment(mode, 3.5, 0).time, 0);
        EXPECT_EQ(clip_moment(mode, 3.5, 0).rounds, 0);
    }
}

TEST(Playback, AnyFiniteTimeIsInTheClip) {
    for (const LoopMode mode : {LoopMode::once, LoopMode::loop, LoopMode::ping_pong}) {
        for (const double duration : {1e-9, 0.1, 1.0 / 3, 7.0}) {
            for (const double time : {1e-300, 0.1, 1e9, 1e18, 1e300, -1e-300, -0.3, -1e9, -1e300}) {
                const double found = clip_moment(mode, time, duration).time;
                EXPECT_TRUE(found >= 0 && found <= duration) << time << " of " << duration;
            }
        }
    }
}

}  // namespace
}  // namespace lanthorn
