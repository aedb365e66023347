// What the screens offer in windows of any size: their entries, options and bindings.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/game/ui_player.h"

namespace lanthorn::game::ui {
namespace {

// What can be done on a screen by moving down and choosing.
std::multiset<Happening> reachable(Screen screen, ivec2 size, int moves, int down, int take, bool by_pad) {
    std::multiset<Happening> found;
    for (int n = 0; n < moves; ++n) {
        Player player(size);
        player.model.screens.begun = true;
        player.show(screen);
        const auto press = [&](int code) {
            return by_pad ? player.button(static_cast<std::size_t>(code)) : player.key(code);
        };
        for (int i = 0; i < n; ++i) {
            EXPECT_FALSE(press(down));
        }
        const ImRect rect = player.chosen();
        EXPECT_GE(rect.Min.y, -1) << "entry " << n << " of screen " << int(screen) << " at " << size.x;
        EXPECT_LT(rect.Min.y, static_cast<float>(size.y) - 4)
            << "entry " << n << " of screen " << int(screen);
        if (const std::optional<Event> event = press(take)) {
            found.insert(event->what);
        }
    }
    return found;
}

TEST(Pages, EveryEntryIsReachedByKeysInWindowsOfAnySize) {
    using enum Happening;
    for (const ivec2 size : kSizes) {
        EXPECT_EQ(reachable(Screen::title, size, 5, GLFW_KEY_DOWN, GLFW_KEY_ENTER, false),
                  (std::multiset<Happening>{play, levels, options, credits, quit}));
        EXPECT_EQ(reachable(Screen::paused, size, 6, GLFW_KEY_DOWN, GLFW_KEY_SPACE, false),
                  (std::multiset<Happening>{play, reset, levels, options, title, quit}));
        EXPECT_EQ(reachable(Screen::restart, size, 2, GLFW_KEY_DOWN, GLFW_KEY_ENTER, false),
                  (std::multiset<Happening>{back, reset}));
        EXPECT_EQ(reachable(Screen::finished, size, 4, GLFW_KEY_DOWN, GLFW_KEY_ENTER, false),
                  (std::multiset<Happening>{next, play, levels, quit}));
    }
}

// After the last room: an end card once all are solved, else the way to what is left.
TEST(Pages, TheLastRoomEndsTheGameWhereAllAreSolved) {
    using enum Happening;
    for (const bool all : {false, true}) {
        std::multiset<Happening> found;
        for (int n = 0; n < (all ? 5 : 4); ++n) {
            Player player({1280, 720});
            player.model.screens.level = 5;
            for (LevelCard& card : player.model.levels) {
                card.solved = card.solved || all;
            }
            player.show(Screen::finished);
            for (int i = 0; i < n; ++i) {
                player.key(GLFW_KEY_DOWN);
            }
            if (const std::optional<Event> event = player.key(GLFW_KEY_ENTER)) {
                found.insert(event->what);
            }
        }
        EXPECT_EQ(found, (all ? std::multiset<Happening>{next, play, levels, credits, quit}
                              : std::multiset<Happening>{next, play, levels, quit}));
    }
}

TEST(Pages, EveryEntryIsReachedByGamepad) {
    using enum Happening;
    const auto by_pad = [](Screen screen, int moves) {
        return reachable(screen, {1280, 720}, moves, GLFW_GAMEPAD_BUTTON_DPAD_DOWN, GLFW_GAMEPAD_BUTTON_A,
                         true);
    };
    EXPECT_EQ(by_pad(Screen::title, 5), (std::multiset<Happening>{play, levels, options, credits, quit}));
    EXPECT_EQ(by_pad(Screen::paused, 6),
              (std::multiset<Happening>{play, reset, levels, options, title, quit}));
}

TEST(Pages, ALanguageIsChosenAmongThoseThatThereAre) {
    Player player({1280, 720});
    player.model.languages = {"de", "en"};
    player.model.language = "en";
    player.show(Screen::options);
    for (int i = 0; i < 8; ++i) {
        player.key(GLFW_KEY_DOWN);
    }
    player.key(GLFW_KEY_RIGHT);
    EXPECT_EQ(player.choices.preferences.language, "de");
}

TEST(Pages, EveryLevelCanBeChosenByKeys) {
    for (const ivec2 size : kSizes) {
        std::set<int> levels;
        for (int way = 0; way < 18; ++way) {
            Player player(size);
            player.show(Screen::levels);
            for (int i = 0; i < way / 3; ++i) {
                player.key(GLFW_KEY_DOWN);
            }
            for (int i = 0; i < way % 3; ++i) {
                player.key(GLFW_KEY_RIGHT);
            }
            const std::optional<Event> event = player.key(GLFW_KEY_ENTER);
            if (event && event->what == Happening::choose) {
                levels.insert(event->level);
            }
        }
        EXPECT_EQ(levels.size(), 6u) << size.x;
    }
}

TEST(Pages, RightAndLeftChangeAnOption) {
    Player player({1280, 720});
    player.show(Screen::options);
    player.key(GLFW_KEY_RIGHT);
    EXPECT_EQ(player.choices.preferences.picture, ivec2(960, 540));
    player.key(GLFW_KEY_LEFT);
    EXPECT_EQ(player.choices.preferences.picture,
              ivec2(480, 270));  // from 640x360, which still is the picture
    player.button(GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
    player.button(GLFW_GAMEPAD_BUTTON_A);
    EXPECT_TRUE(player.choices.preferences.fullscreen);
}

TEST(Pages, APictureOfNoneOfTheSizesGrowsAndShrinksByOne) {
    Player player({1280, 720});
    player.show(Screen::options);
    const auto stepped = [&](const ivec2& from, int key) {
        player.model.picture = from;
        player.key(key);
        return player.choices.preferences.picture;
    };
    EXPECT_EQ(stepped({700, 400}, GLFW_KEY_RIGHT), ivec2(960, 540));
    EXPECT_EQ(stepped({700, 400}, GLFW_KEY_LEFT), ivec2(640, 360));
    EXPECT_EQ(stepped({320, 180}, GLFW_KEY_LEFT), ivec2(320, 180));
    EXPECT_EQ(stepped({160, 90}, GLFW_KEY_LEFT), ivec2(320, 180));
    EXPECT_EQ(stepped({160, 90}, GLFW_KEY_RIGHT), ivec2(320, 180));
    EXPECT_EQ(stepped({3840, 2160}, GLFW_KEY_RIGHT), ivec2(320, 180));
}

TEST(Pages, AKeyIsBoundToTheActionThatAskedForIt) {
    Player player({1280, 720});
    player.show(Screen::controls);
    for (int i = 0; i < 4; ++i) {
        player.key(GLFW_KEY_DOWN);
    }
    player.key(GLFW_KEY_ENTER);
    ASSERT_EQ(player.choices.asked, Action::use);
    player.key(GLFW_KEY_ENTER);  // is a key like others
    EXPECT_FALSE(player.choices.asked);
    EXPECT_TRUE(player.choices.bindings.binds({Trigger::Device::keyboard, GLFW_KEY_ENTER}, Action::use));
    EXPECT_FALSE(player.choices.bindings.binds({Trigger::Device::keyboard, GLFW_KEY_E}, Action::use));
    EXPECT_TRUE(player.choices.bindings.binds({Trigger::Device::pad, GLFW_GAMEPAD_BUTTON_A}, Action::use));
}

TEST(Pages, TheMenusKeyIsBoundToNothingElse) {
    Player player({1280, 720});
    player.show(Screen::controls);
    player.key(GLFW_KEY_ENTER);
    ASSERT_EQ(player.choices.asked, Action::forward);
    EXPECT_FALSE(player.key(GLFW_KEY_ESCAPE));  // leaves the question, not the screen
    EXPECT_EQ(player.choices.bindings, usual_bindings());
    EXPECT_FALSE(player.choices.asked);
}

}  // namespace
}  // namespace lanthorn::game::ui
