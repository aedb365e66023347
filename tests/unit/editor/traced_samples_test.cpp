// How far a picture has come whose samples grow, and how long the rest is said to take.
#include "tools/editor/core/traced_samples.h"

#include <gtest/gtest.h>

namespace lanthorn::editor {
namespace {

TEST(TracedSamples, SayHowFarAndHowLong) {
    TracedSamples traced;
    EXPECT_FALSE(traced.grows());
    EXPECT_EQ(traced.words(), "");
    traced.drew({1, 64, false}, 900);  // with what the first frame makes
    EXPECT_EQ(traced.words(), "1 of 64 samples");
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.9 * 63);
    for (int done = 2; done <= 8; ++done) {
        traced.drew({done, 64, false}, 250);
    }
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.25 * 56);
    EXPECT_EQ(traced.left_words(), "14 s left");
    traced.drew({9, 64, false}, 4000);  // another program was at work
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.25 * 55);
    EXPECT_DOUBLE_EQ(traced.share(), 9.0 / 64);
    traced.drew({64, 64, true}, 250 * 55);
    EXPECT_TRUE(traced.grows());
    EXPECT_FALSE(traced.due());
    EXPECT_EQ(traced.left_words(), "");
}

TEST(TracedSamples, SeveralAFrameAreCountedEach) {
    TracedSamples traced;
    traced.drew({8, 64, false}, 800);
    traced.drew({16, 64, false}, 800);
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.1 * 48);
}

// What the passes of another picture took says nothing of this one; nor does a frame without samples.
TEST(TracedSamples, BeginAgainWithThePicture) {
    TracedSamples traced;
    for (int done = 1; done <= 20; ++done) {
        traced.drew({done, 64, false}, 1000);
    }
    traced.drew({1, 64, false}, 100);
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.1 * 63);
    traced.drew({1, 64, false}, 7000);
    EXPECT_DOUBLE_EQ(traced.seconds_left().value(), 0.1 * 63);
    traced.drew({}, 30);
    EXPECT_FALSE(traced.grows());
    EXPECT_FALSE(traced.seconds_left());
}

// A noise that was asked for ends it before all samples are taken.
TEST(TracedSamples, EndBeforeAllAreTaken) {
    TracedSamples traced;
    traced.drew({10, 1000, true}, 100);
    EXPECT_FALSE(traced.due());
    EXPECT_EQ(traced.words(), "10 of 1000 samples");
    EXPECT_FALSE(traced.seconds_left());
}

// Of what a sample is said to take, nothing being timed.
TEST(TracedSamples, TellTheRestOfWhatASampleTakes) {
    TracedSamples traced;
    traced.drew({3, 64, false}, 0);
    EXPECT_FALSE(traced.seconds_left());
    EXPECT_DOUBLE_EQ(traced.seconds_left(500), 0.5 * 61);
    traced.drew({3, 64, true}, 0);
    EXPECT_DOUBLE_EQ(traced.seconds_left(500), 0);
}

}  // namespace
}  // namespace lanthorn::editor
