// How far a still picture is refined, and what the badge says of it.
#include "tools/editor/window/refinement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/gi/gi_plugin.h"

namespace lanthorn::edit_window {
namespace {

Settings settings(const std::string& technique = "emc") {
    struct All : SettingsSchema {
        All() { gi::declare_settings(*this); }
    };
    static const All schema;
    Settings result(schema);
    result.set_from_text("gi.technique", technique);
    return result;
}

// Frames of `ms` whose error falls as the root of their number until none is due; returns how many.
int refine(Refinement& refinement, double from, double ms, int* estimates = nullptr) {
    int frames = 0, asked = 0;
    while (refinement.due() && frames < 100'000) {
        ++frames;
        if (refinement.drew(ms)) {
            ++asked;
            refinement.estimated(from / std::sqrt(1.0 + frames));
        }
    }
    if (estimates != nullptr) {
        *estimates = asked;
    }
    return frames;
}

TEST(Refinement, GoesOnUntilTheErrorIsReached) {
    Refinement refinement;
    EXPECT_FALSE(refinement.due());
    EXPECT_EQ(refinement.words(), "");
    refinement.begin(0.4, settings());
    ASSERT_TRUE(refinement.due());
    EXPECT_FALSE(refinement.begun());
    EXPECT_EQ(refinement.words(), "");
    refinement.drew(10);
    EXPECT_EQ(refinement.words(), "refining: error about 0.4");
    int estimates = 0;
    const int frames = refine(refinement, 0.4, 10, &estimates);
    EXPECT_GE(frames, 98);  // 0.4 / 0.04 squared
    EXPECT_LE(frames, 115);
    EXPECT_LE(estimates, 20);  // an eighth more frames between two
    EXPECT_EQ(refinement.words().substr(0, 21), "refined: error about ");
}

TEST(Refinement, EndsAfterItsTimeAndSaysSo) {
    Refinement refinement;
    refinement.begin(4, settings());
    EXPECT_EQ(refine(refinement, 4, 200), static_cast<int>(Refinement::kMostSeconds * 5));
    EXPECT_EQ(refinement.words().substr(0, 29), "refined for 20 s: error about") << refinement.words();
    refinement.forget();
    EXPECT_EQ(refinement.words(), "");
    EXPECT_FALSE(refinement.due());
}

TEST(Refinement, GoesAsFarAsSettingsSay) {
    Settings asked = settings();
    asked.set("gi.target_error", 0.1f);
    asked.set("gi.accumulate", 30);
    Refinement refinement;
    refinement.begin(0.4, asked);
    EXPECT_LE(refine(refinement, 0.4, 10), 24);
    refinement.begin(4, asked);
    EXPECT_EQ(refine(refinement, 4, 10), 46);  // the rays of all directions, and as many passes
    // What is good enough already needs no frame.
    refinement.begin(0.09, asked);
    EXPECT_FALSE(refinement.due());
    EXPECT_EQ(refinement.words(), "error about 0.09");
}

TEST(Refinement, IsOfTechniquesThatSayHowGoodTheyAre) {
    EXPECT_TRUE(Refinement::possible(settings()));
    EXPECT_FALSE(Refinement::possible(settings("none")));
    Refinement refinement;
    refinement.begin(std::nullopt, settings());
    EXPECT_FALSE(refinement.due());
    Settings prepared = settings();
    prepared.set("gi.target_error", 0.1f);
    Refinement::prepare(prepared);
    EXPECT_GT(prepared.get<int>("gi.accumulate"), 1000);
    EXPECT_EQ(prepared.get<float>("gi.target_error"), 0);
    prepared.set("gi.accumulate", 5);
    Refinement::prepare(prepared);
    EXPECT_EQ(prepared.get<int>("gi.accumulate"), 5);
}

}  // namespace
}  // namespace lanthorn::edit_window
