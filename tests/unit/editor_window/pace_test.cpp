// When the editor draws, and how well.
#include "tools/editor/window/pace.h"

#include <gtest/gtest.h>

namespace lanthorn::edit_window {
namespace {

// Frames of `ms` at the whole size until none is due; returns how many. The picture settles after `settles`.
int rest(Pace& pace, double now, double ms, int settles) {
    int frames = 0;
    while (pace.due() && frames < 1000) {
        const Quality quality = pace.quality(now);
        EXPECT_NE(quality, Quality::drag);
        pace.drew(quality, pace.scale(now), ms, frames < settles ? 0.2 : 0);
        ++frames;
    }
    return frames;
}

TEST(Pace, AStillPictureIsDrawnNoMore) {
    Pace pace;
    EXPECT_TRUE(pace.due());
    EXPECT_EQ(rest(pace, 10, 80, 3), Pace::kFewest);
    EXPECT_EQ(pace.quality(10), Quality::still);
    pace.changed(11, false);
    EXPECT_TRUE(pace.due());
    EXPECT_EQ(pace.quality(11), Quality::rest);
    EXPECT_EQ(rest(pace, 11, 80, 20), 21);
    pace.changed(12, false);
    EXPECT_EQ(rest(pace, 12, 80, 1000), Pace::kMost);  // it flickers
}

TEST(Pace, FollowsAHandByASmallerPictureAndComesToRest) {
    Pace pace;
    rest(pace, 1, 240, 3);
    pace.hold(true, 2);
    pace.changed(2, true);
    EXPECT_EQ(pace.quality(2), Quality::drag);
    const double scale = pace.scale(2);
    EXPECT_LT(scale, 0.6);
    EXPECT_GE(scale, 0.25);
    EXPECT_EQ(pace.scale(2.05), scale);
    pace.hold(false, 3);
    EXPECT_EQ(pace.quality(3), Quality::drag);
    EXPECT_EQ(pace.quality(3 + Pace::kRestAfter), Quality::rest);
    EXPECT_EQ(pace.scale(3 + Pace::kRestAfter), 1);
}

TEST(Pace, ChangesSizeOnceInAGestureAtMost) {
    Pace pace;
    pace.hold(true, 1);
    pace.changed(1, true);
    double before = pace.scale(1);
    EXPECT_EQ(before, 1);  // nothing is known of the scene
    int changes = 0;
    for (int i = 0; i < 60; ++i) {
        pace.changed(1 + 0.1 * i, true);
        const double scale = pace.scale(1 + 0.1 * i);
        changes += scale != before ? 1 : 0;
        before = scale;
        pace.drew(Quality::drag, scale, 400, 1);
    }
    EXPECT_EQ(changes, 1);
    EXPECT_LT(before, 1);
}

TEST(Pace, AnotherGestureBeginsWithTheSizeThatTheLastOneNeeded) {
    Pace pace;
    rest(pace, 1, 60, 3);  // what holds is kept
    const auto gesture = [&](double from) {
        pace.hold(true, from);
        pace.changed(from, true);
        const double scale = pace.scale(from);
        for (int i = 0; i < 20; ++i) {
            pace.changed(from + 0.1 * i, true);
            const double now = pace.scale(from + 0.1 * i);
            pace.drew(Quality::drag, now, 400 * (0.35 + 0.65 * now * now), 1);
        }
        pace.hold(false, from + 2);
        rest(pace, from + 3, 60, 3);
        return scale;
    };
    EXPECT_GT(gesture(2), 0.8);
    EXPECT_EQ(gesture(10), 0.25);
    EXPECT_EQ(gesture(20), 0.25);
}

TEST(Pace, AHandThatHoldsStillIsNotDrawnForEver) {
    Pace pace;
    pace.hold(true, 1);
    pace.changed(1, true);
    int frames = 0;
    while (pace.due() && frames < 1000) {
        pace.drew(Quality::drag, 1, 50, 1);
        ++frames;
    }
    EXPECT_EQ(frames, Pace::kMostInHand);
}

}  // namespace
}  // namespace lanthorn::edit_window
