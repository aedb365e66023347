// Keys, buttons and the mouse on the screens: what they choose, in their order, each on the screen that it is
// for.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/unit/game/ui_player.h"

namespace lanthorn::game::ui {
namespace {

TEST(Pages, UpFromTheFirstEntryIsTheLast) {
    for (const ivec2 size : kSizes) {
        Player player(size);
        player.show(Screen::paused);
        player.key(GLFW_KEY_UP);
        const std::optional<Event> event = player.key(GLFW_KEY_ENTER);
        ASSERT_TRUE(event) << size.x;
        EXPECT_EQ(event->what, Happening::quit) << size.x;
    }
}

TEST(Pages, EscapeAndTheGamepadsBGoBack) {
    for (const Screen screen : {Screen::levels, Screen::paused, Screen::options, Screen::controls,
                                Screen::finished, Screen::credits}) {
        Player player({1280, 720});
        player.show(screen);
        const std::optional<Event> by_key = player.key(GLFW_KEY_ESCAPE);
        const std::optional<Event> by_pad = player.button(GLFW_GAMEPAD_BUTTON_B);
        ASSERT_TRUE(by_key && by_pad) << int(screen);
        EXPECT_EQ(by_key->what, Happening::back);
        EXPECT_EQ(by_pad->what, Happening::back);
    }
}

TEST(Pages, TheMenusKeyAndButtonGoBackWhereverTheyWereMoved) {
    Player player({1280, 720});
    player.choices.bindings.bind(Action::menu,
                                 {*input::find_trigger("F10"), *input::find_trigger("Pad Start")});
    for (const Screen screen : {Screen::levels, Screen::paused, Screen::options, Screen::controls}) {
        player.show(screen);
        EXPECT_TRUE(player.key(GLFW_KEY_F10)) << int(screen);
        EXPECT_TRUE(player.key(GLFW_KEY_ESCAPE)) << int(screen);
        EXPECT_TRUE(player.button(GLFW_GAMEPAD_BUTTON_START)) << int(screen);
        EXPECT_FALSE(player.key(GLFW_KEY_F9)) << int(screen);
    }
}

TEST(Pages, WhatChoosesOnTheScreensDoesSoAlsoWhereItIsTheMenus) {
    Player player({1280, 720});
    player.choices.bindings.bind(Action::menu,
                                 {*input::find_trigger("Enter"), *input::find_trigger("Pad A")});
    player.show(Screen::paused);
    player.key(GLFW_KEY_DOWN);
    const std::optional<Event> by_key = player.key(GLFW_KEY_ENTER);
    const std::optional<Event> by_pad = player.button(GLFW_GAMEPAD_BUTTON_A);
    ASSERT_TRUE(by_key && by_pad);
    EXPECT_EQ(by_key->what, Happening::reset);
    EXPECT_EQ(by_pad->what, Happening::reset);
}

// A button that has just become the menu's is still down.
TEST(Pages, TheMenusNewButtonDoesNotLeaveTheScreenThatItIsChosenOn) {
    Player player({1280, 720});
    player.show(Screen::controls);
    player.choices.asked = Action::menu;
    PadState pad;
    pad.buttons[GLFW_GAMEPAD_BUTTON_GUIDE] = true;
    for (int i = 0; i < 6; ++i) {
        EXPECT_FALSE(player.frame({}, pad)) << i;
    }
    EXPECT_TRUE(player.choices.bindings.binds(*input::find_trigger("Pad Guide"), Action::menu));
    EXPECT_TRUE(player.button(GLFW_GAMEPAD_BUTTON_START) == std::nullopt);
    EXPECT_TRUE(player.button(GLFW_GAMEPAD_BUTTON_GUIDE));
}

TEST(Pages, KeysThatComeWithinAFrameKeepTheirOrder) {
    Player player({1280, 720});
    player.show(Screen::paused);
    std::optional<Event> event =
        player.frame({GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_ENTER});
    for (int i = 0; i < 12 && !event; ++i) {
        event = player.frame();
    }
    ASSERT_TRUE(event);
    EXPECT_EQ(event->what, Happening::title);
    event = player.frame({GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_UP, GLFW_KEY_ENTER});  // around, and back
    for (int i = 0; i < 12 && !event; ++i) {
        event = player.frame();
    }
    ASSERT_TRUE(event);
    EXPECT_EQ(event->what, Happening::quit);
}

// As somebody types who knows the way: no key is lost where one screen leads to another.
TEST(Pages, KeysWaitForTheScreenThatTheyAreFor) {
    Player player({1280, 720});
    player.show(Screen::paused);
    std::optional<Event> event = player.frame({GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_ENTER,
                                               GLFW_KEY_DOWN, GLFW_KEY_DOWN, GLFW_KEY_RIGHT});
    player.choices.preferences.preset = "low";
    for (int i = 0; i < 24; ++i) {
        if (event) {
            player.model.screens = follow(player.model.screens, *event).to;
        }
        event = player.frame();
    }
    EXPECT_EQ(player.model.screens.at, Screen::options);
    EXPECT_EQ(player.choices.preferences.preset, "medium");
}

// The key that opens the menu does not close it at once.
TEST(Pages, AKeyCountsOnOneScreenOnly) {
    Player player({1280, 720});
    player.show(Screen::play);
    player.model.screens.at = Screen::paused;
    EXPECT_FALSE(player.frame({GLFW_KEY_ESCAPE}));
    EXPECT_TRUE(player.key(GLFW_KEY_ESCAPE));
}

// After looking about with the mouse too: it stands where it was left, and the first key moves.
TEST(Pages, WhatIsChosenIsSeenWhateverTheMouseDidBefore) {
    Player player({1280, 720});
    player.show(Screen::play);
    ImGui::GetIO().MousePos = {1000, 600};
    player.frame();
    ImGui::GetIO().MousePos = {1100, 500};
    player.frame();
    player.model.screens.at = Screen::finished;
    for (int i = 0; i < 3; ++i) {
        player.frame();
        // On the way, the pointer is put back to where it was.
        ImGui::GetIO().MousePos = {1000, 600};
    }
    player.key(GLFW_KEY_DOWN);
    const std::optional<Event> event = player.key(GLFW_KEY_ENTER);
    ASSERT_TRUE(event);
    EXPECT_EQ(event->what, Happening::play);  // the second entry
}

// 0.4 s, then every 0.1 s; and it does not go round.
TEST(Pages, AHeldArrowRepeatsSlowlyAndStopsAtTheEnd) {
    Player player({1280, 720});
    ImGui::GetIO().KeyRepeatDelay = 0.4f / 0.72f;  // as Interface sets them
    ImGui::GetIO().KeyRepeatRate = 0.1f / 0.8f;
    player.show(Screen::options);
    const float first = player.chosen().Min.y;
    const auto rows_down = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            player.hold(GLFW_KEY_DOWN);
        }
        return player.chosen().Min.y - first;
    };
    const float one = rows_down(3);
    EXPECT_GT(one, 0);
    EXPECT_EQ(rows_down(3), one);  // 0.3 s
    EXPECT_GT(rows_down(6), one);  // 0.6 s
    rows_down(200);
    const float last = player.chosen().Min.y;
    rows_down(20);
    EXPECT_EQ(player.chosen().Min.y, last);
}

}  // namespace
}  // namespace lanthorn::game::ui
