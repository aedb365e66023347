// Words on the screens: in the player's language, inside the window, on a dark ground.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "game/presentation/languages.h"
#include "tests/support/repository.h"
#include "tests/unit/game/ui_player.h"

namespace lanthorn::game::ui {
namespace {

// In German: nothing that the pages and the picture say is missing in the table.
TEST(Pages, SayEverythingInThePlayersLanguage) {
    Languages languages(support::repository_file("assets/languages"), [](const std::string&) {});
    const Words& german = languages.words("de");
    Player player({1280, 720});
    player.model.words = &german;
    player.model.languages = languages.codes();
    player.model.language = "de";
    player.choices.preferences.preset = player.model.drawn_preset = "ultra";
    player.model.by_pad = true;
    player.model.looks_by = "right stick";
    player.model.captions = {"a crystal rings"};
    for (const bool begun : {false, true}) {
        for (const int level : {0, 5}) {
            for (const Screen screen :
                 {Screen::loading, Screen::title, Screen::levels, Screen::play, Screen::paused,
                  Screen::restart, Screen::options, Screen::controls, Screen::finished, Screen::credits}) {
                player.model.screens.begun = begun;
                player.model.screens.level = level;
                player.model.prompts = Lessons().prompts({.carries = true, .lit = begun, .glasses = 1});
                player.show(screen);
            }
        }
    }
    player.model.screens.level = 5;
    for (LevelCard& each : player.model.levels) {
        each.solved = true;
    }
    player.show(Screen::finished);  // the end card
    player.choices.asked = Action::use;
    player.show(Screen::controls);
    player.choices.preferences.hold_by_press = player.choices.preferences.captions = true;
    player.choices.preferences.fullscreen = player.choices.preferences.invert_look = true;
    player.choices.asked.reset();
    player.choices.bindings.bind(Action::use, {});
    player.show(Screen::options);
    player.show(Screen::controls);
    player.model.reveal = RevealMark{.place = vec2(0.5f), .seconds = 1, .awake = 1, .all = 2};
    player.show(Screen::play);
    std::set<std::string> unknown = german.unknown();
    for (const char* title : {"One", "Two", "Three", "Four", "Five", "Six"}) {
        unknown.erase(title);
    }
    for (const std::string& word : unknown) {
        ADD_FAILURE() << "de.json has no word for '" << word << "'";
    }
}

TEST(Pages, WordsAreDrawnInsideWindowsOfAnySize) {
    for (const ivec2 size : kSizes) {
        Player player(size);
        player.model.hud.labels = {{{0.99f, 0.5f}, Action::use, "open the door"},
                                   {{0.98f, 0.51f}, Action::carry, "take the lantern"},
                                   {{0.9f, 0.5f}, Action::light, "light it"},
                                   {{0.5f, 3.0f}, Action::colour, "far below"}};
        player.model.hud.marks = {{{0.3f, 0.3f}, 3, Symbol::moon, 0.4f, false}};
        player.model.symbols = true;
        player.model.hint = "A hint that is long enough to need more than a line in a small window.";
        player.model.notices = {"a line to be read"};
        player.show(Screen::play);
        const ImDrawList& drawn = *ImGui::GetBackgroundDrawList();
        ASSERT_GT(drawn.VtxBuffer.Size, 100);
        const auto width = static_cast<float>(size.x), height = static_cast<float>(size.y);
        for (const ImDrawVert& vertex : drawn.VtxBuffer) {
            EXPECT_LT(vertex.pos.x, width + 2) << size.x;
            EXPECT_GT(vertex.pos.x, -2) << size.x;
            EXPECT_LT(vertex.pos.y, height + 2) << size.x;
        }
    }
}

// Keys go through the credits to the last one, at the largest text in a small window, and back.
TEST(Pages, CreditsScrollByKeys) {
    Player player({640, 360}, 2);
    player.show(Screen::credits);
    player.key(GLFW_KEY_UP);  // from the first line round to the last
    const ImGuiWindow& column = *ImGui::FindWindowByName("credits");
    ASSERT_GT(column.ScrollMax.y, 360);
    EXPECT_GT(player.chosen().Min.y, 0);
    EXPECT_LE(player.chosen().Max.y, 360);
    EXPECT_GT(column.Scroll.y, 0.6f * column.ScrollMax.y);
    player.key(GLFW_KEY_DOWN);
    EXPECT_GE(player.chosen().Min.y, 0);
    EXPECT_LT(column.Scroll.y, 0.2f * column.ScrollMax.y);
}

// What has words as wide as its column is dark as far as the column goes, whatever the picture behind shows.
TEST(Pages, LongWordsStandOnTheShade) {
    constexpr float kDark = 0.6f;
    for (const double text_size : {1.0, 2.0}) {
        for (const Screen screen : {Screen::options, Screen::controls, Screen::credits}) {
            Player player({1280, 720}, text_size);
            player.show(screen);
            float shaded = 0;
            for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer) {
                const auto alpha = static_cast<float>(vertex.col >> IM_COL32_A_SHIFT & 0xff) / 255;
                shaded = alpha > kDark ? std::max(shaded, vertex.pos.x) : shaded;
            }
            EXPECT_GE(shaded, std::min(lanthorn::ui::kColumnUnits * player.model.page.unit, 1280.0f))
                << text_size << ' ' << static_cast<int>(screen);
        }
    }
}

}  // namespace
}  // namespace lanthorn::game::ui
