#include "gi_module/techniques/emc/maps/progressive_update.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace lanthorn::gi {
namespace progressive_update_test {

// One letter a frame: the share that is seen, '.' for none; behind it '?' where it is asked what the round
// before has found, '!' where a map may be exchanged, '*' where it is: the first `exchanges` times.
std::string frames(ProgressiveUpdate& update, int count, int interval,
                   const std::function<bool(int)>& geometry_changes, int exchanges = 0) {
    std::string done;
    for (int frame = 0; frame < count; ++frame) {
        const bool changes = geometry_changes(frame);
        const ProgressiveUpdate::Step step = update.step(changes, interval);
        done += step.share < 0 ? "." : std::to_string(step.share);
        done += step.ask ? "?" : "";
        const bool exchanged = step.exchange && exchanges-- > 0;
        done += exchanged ? "*" : step.exchange ? "!" : "";
        update.advance(changes, exchanged, step);
    }
    return done;
}

std::string frames(int count, int interval, const std::function<bool(int)>& geometry_changes,
                   int exchanges = 0) {
    ProgressiveUpdate update;
    return frames(update, count, interval, geometry_changes, exchanges);
}

bool never(int /*frame*/) {
    return false;
}

bool at_first(int frame) {
    return frame == 0;
}

TEST(ProgressiveUpdate, StillGeometryIsNotLookedAt) {
    EXPECT_EQ(frames(8, 5, [](int) { return false; }), "........");
    EXPECT_FALSE(ProgressiveUpdate().step(false, 5).round);
}

TEST(ProgressiveUpdate, OnceEveryFiveFramesOfMotion) {
    EXPECT_EQ(frames(12, 5, [](int) { return true; }), "012340?1!2340?1!");
}

TEST(ProgressiveUpdate, WhatMovedBeforeTheLookIsSeenByOneRound) {
    // The next round has begun, and is given up.
    EXPECT_EQ(frames(12, 5, [](int frame) { return frame == 1; }), ".012340?1!....");
}

TEST(ProgressiveUpdate, RoundsGoOnUntilOneChangesNothing) {
    EXPECT_EQ(frames(14, 5, at_first, 1), "012340?1*2340?1!..");
    EXPECT_EQ(frames(19, 5, at_first, 2), "012340?1*2340?1*2340?1!..");
    EXPECT_EQ(frames(9, 2, at_first, 2), "010?1*0?1*0?1!.");
    // The exchange of a round of one frame comes after the next round has asked.
    EXPECT_EQ(frames(9, 1, at_first, 1), "00?0?*0?!0?!....") << "the next one does";
    EXPECT_EQ(frames(32, 16, at_first, 0), "......0123456789.?.!..............");
}

TEST(ProgressiveUpdate, ExchangesComeToAnEnd) {
    ProgressiveUpdate update;
    frames(update, 1000, 5, at_first, 1000);
    EXPECT_FALSE(update.step(false, 5).round);
    EXPECT_EQ(frames(update, 4, 5, never, 1000), "....");
    EXPECT_EQ(frames(update, 7, 5, at_first, 1000), "012340?1*");
}

TEST(ProgressiveUpdate, WhatMovedDuringTheLookIsSeenByAnother) {
    EXPECT_EQ(frames(14, 5, [](int frame) { return frame < 2; }), "012340?1!2340?1!..");
    EXPECT_EQ(frames(14, 5, [](int frame) { return frame < 5; }), "012340?1!2340?1!..");
    EXPECT_EQ(frames(14, 5, [](int frame) { return frame == 0 || frame == 5; }), "012340?1!2340?1!..");
}

TEST(ProgressiveUpdate, ALongIntervalLooksInItsLastFrames) {
    EXPECT_EQ(frames(20, 16, [](int frame) { return frame < 3; }), "......0123456789.?.!..");
    EXPECT_EQ(frames(18, 13, [](int) { return true; }), "...0123456789.?.!.01");
    const ProgressiveUpdate::Step step = ProgressiveUpdate().step(true, 16);
    EXPECT_EQ(step.frames_left, 15);
    EXPECT_EQ(step.frames_to_look(), 6);
}

TEST(ProgressiveUpdate, AnIntervalOfOneLooksAtAllInEveryFrame) {
    EXPECT_EQ(frames(4, 1, [](int frame) { return frame != 2; }), "00?0?!0?!");
}

TEST(ProgressiveUpdate, ChosenAnewIsLookedAt) {
    ProgressiveUpdate update;
    EXPECT_EQ(frames(update, 3, 5, [](int) { return true; }), "012");
    update.reset();
    EXPECT_EQ(frames(update, 6, 5, [](int) { return false; }), "......");
    EXPECT_EQ(frames(update, 5, 5, [](int) { return true; }), "01234");
}

TEST(ProgressiveUpdate, AnotherIntervalBeginsTheRoundAnew) {
    ProgressiveUpdate update;
    EXPECT_EQ(frames(update, 3, 5, [](int) { return true; }), "012");
    update.restart_round();
    EXPECT_EQ(frames(update, 4, 2, [](int frame) { return frame == 0; }), "010?1!");
}

TEST(ProgressiveUpdate, EveryCandidateIsInOneShare) {
    for (const int candidates : {0, 1, 2, 7, 40, 64}) {
        for (const int shares : {1, 2, 5, 10}) {
            int next = 0;
            int largest = 0;
            for (int share = 0; share < shares; ++share) {
                const auto [first, end] = ProgressiveUpdate::candidates(share, shares, candidates, 8);
                EXPECT_EQ(first, next) << candidates << ' ' << shares << ' ' << share;
                EXPECT_GE(end, first);
                largest = std::max(largest, end - first);
                next = end;
            }
            EXPECT_EQ(next, candidates);
            const auto [first, end] = ProgressiveUpdate::candidates(0, shares, candidates, 8);
            EXPECT_LE(end - first, largest) << "the round before is asked about in its frame";
        }
    }
}

}  // namespace progressive_update_test
}  // namespace lanthorn::gi
