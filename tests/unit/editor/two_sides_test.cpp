// Ways to draw, by their words, and two pictures in one.
#include "tools/editor/core/two_sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"

namespace lanthorn::editor {
namespace {

TEST(TwoSides, AreNamedByTechniqueAndPreset) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    DrawnAs now{Settings(schema), "low"};
    now.settings.apply_preset("low");
    now.settings.set_from_text("gi.photons", "1234");
    now.settings.set_from_text("render.upscale", "temporal");

    const DrawnAs none = drawn_as("none", now);
    EXPECT_EQ(words_of(none), "none low");
    EXPECT_EQ(none.settings.text("gi.photons"), "1234");  // all but the technique stays
    const DrawnAs high = drawn_as("/high", now);
    EXPECT_EQ(words_of(high), "emc high");
    EXPECT_NE(high.settings.text("gi.photons"), "1234");
    EXPECT_EQ(high.settings.text("render.upscale"), "temporal");
    EXPECT_EQ(words_of(drawn_as("none/medium", now)), "none medium");
    EXPECT_EQ(words_of({now.settings, ""}), "emc");
    for (const char* wrong : {"", "paths", "emc/", "emc/fine", "emc/low/high"}) {
        EXPECT_THROW(drawn_as(wrong, now), InputError) << wrong;
    }
}

// An exposure of B's, stops and all, is what A has then.
TEST(TwoSides, HaveOneExposure) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings settings(schema);
    settings.set_from_text("render.exposure.compensation", "1");
    const double ev = ev100_of(settings, 0.25);
    EXPECT_NEAR(std::exp2(1.0) / (1.2 * std::exp2(ev)), 0.25, 1e-12);
    const Settings held = with_exposure(settings, ev);
    EXPECT_EQ(held.text("render.exposure.mode"), "manual");
    EXPECT_NEAR(static_cast<double>(held.get<float>("render.exposure.ev100")), ev, 1e-6);
    EXPECT_EQ(held.text("render.exposure.compensation"), "1");
    EXPECT_NO_THROW(with_exposure(settings, ev100_of(settings, 0)));
}

TEST(TwoSides, StandBesideALine) {
    const ImageF a{8, 2, 1, std::vector<float>(16, 0.25f), {}}, b{8, 2, 1, std::vector<float>(16, 0.5f), {}};
    const ImageF both = side_by_side(a, b, 0.5);
    EXPECT_EQ(both.at(3, 1, 0), 0.25f);
    EXPECT_EQ(both.at(4, 1, 0), 1.0f);
    EXPECT_EQ(both.at(5, 0, 0), 0.5f);
}

}  // namespace
}  // namespace lanthorn::editor
