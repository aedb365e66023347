#include "game/presentation/preferences.h"

#include "lanthorn/core/error.h"
#include "tests/support/kept_folder.h"

namespace lanthorn::game {
namespace {

using support::damaged;

Preferences chosen() {
    return {.picture = {960, 540},
            .preset = "high",
            .fullscreen = true,
            .frame_budget = 33.3,
            .field_of_view = 72,
            .brightness = -0.5,
            .mouse = 1.7,
            .stick = 2.1,
            .dead_zone = 0.3,
            .invert_look = true,
            .hold_by_press = true,
            .text_size = 1.5,
            .effects = 0.3,
            .music = 0,
            .captions = true,
            .symbols = true,
            .less_motion = true,
            .flicker = false,
            .rim = false,
            .language = "de"};
}

TEST(Preferences, AreReadAsWritten) {
    EXPECT_EQ(preferences_from_json(to_json(chosen()), "f"), chosen());
    EXPECT_EQ(preferences_from_json(to_json({}), "f"), Preferences());
}

TEST(Preferences, WhatIsMissingTakesItsDefault) {
    const Preferences some = preferences_from_json(R"({"version": 1, "mouse": 2, "of later": [1]})", "f");
    Preferences expected;
    expected.mouse = 2;
    EXPECT_EQ(some, expected);
}

TEST(Preferences, WhatDoesNotFitIsRefusedByName) {
    for (const auto& [text, name] : std::vector<std::pair<std::string, std::string>>{
             {"", "JSON"},
             {"[1]", "JSON"},
             {"{}", "version"},
             {R"({"version": 2})", "version"},
             {R"({"version": "1"})", "version"},
             {R"({"version": 1, "mouse": 0.1})", "mouse"},
             {R"({"version": 1, "field_of_view": 40})", "field_of_view"},
             {R"({"version": 1, "brightness": 1.5})", "brightness"},
             {R"({"version": 1, "dead_zone": 1})", "dead_zone"},
             {R"({"version": 1, "language": 3})", "language"},
             {R"({"version": 1, "captions": "yes"})", "captions"},
             {R"({"version": 1, "mouse": "fast"})", "mouse"},
             {R"({"version": 1, "mouse": 1e999})", "JSON"},
             {R"({"version": 1, "text_size": 40})", "text_size"},
             {R"({"version": 1, "frame_budget": -1})", "frame_budget"},
             {R"({"version": 1, "music": 1.1})", "music"},
             {R"({"version": 1, "effects": -0.1})", "effects"},
             {R"({"version": 1, "fullscreen": 1})", "fullscreen"},
             {R"({"version": 1, "preset": "best"})", "preset"},
             {R"({"version": 1, "picture": [640]})", "picture"},
             {R"({"version": 1, "picture": [640, 99999999999]})", "picture"},
             {R"({"version": 1, "picture": [640, -360]})", "picture"}}) {
        try {
            preferences_from_json(text, "options.json");
            ADD_FAILURE() << text << " was accepted";
        } catch (const InputError& e) {
            const std::string line = e.what();
            EXPECT_TRUE(line.starts_with("options.json")) << line;
            EXPECT_NE(line.find(name), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    }
}

class PreferencesFile : public support::KeptFolder {};

TEST_F(PreferencesFile, ADamagedOneGivesTheDefaultsAndIsKeptAside) {
    put("{\"version\": 1, \"mouse\": ");
    shell::KeptFile kept = file();
    EXPECT_EQ(read_preferences(kept), Preferences());
    EXPECT_TRUE(has("kept.damaged"));
    EXPECT_EQ(said.size(), 1u);
    kept.write(to_json(chosen()));
    EXPECT_EQ(read_preferences(kept), chosen());
}

TEST_F(PreferencesFile, AnyBytesGiveUsableOptionsOrAreSaid) {
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        put(damaged(to_json(chosen()), random));
        shell::KeptFile kept = file();
        said.clear();
        const Preferences read = read_preferences(kept);
        EXPECT_EQ(preferences_from_json(to_json(read), "f"), read);
        EXPECT_EQ(said.size(), has("kept") ? 0u : 1u);
        std::filesystem::remove(folder / "kept.damaged");
    }
}

}  // namespace
}  // namespace lanthorn::game
