// The screens without a window: Dear ImGui draws into memory, keys and a gamepad are pressed by hand.
#include "game/screens/pages.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <set>

#include "game/presentation/languages.h"
#include "game/screens/menu_keys.h"
#include "lanthorn/ui/gamepad_navigation.h"
#include "lanthorn/ui/key_queue.h"
#include "tests/support/repository.h"

namespace lanthorn::game::ui {
namespace {

constexpr ivec2 kSizes[] = {{200, 100}, {640, 360}, {1280, 720}, {3840, 2160}};

class Player {
  public:
    explicit Player(ivec2 size, double text_size = 1) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
        io.DeltaTime = 0.05f;
        io.ConfigFlags = ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad;
        for (const auto& [key, code] : {std::pair(ImGuiKey_UpArrow, GLFW_KEY_UP),
                                        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                        {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                        {ImGuiKey_Space, GLFW_KEY_SPACE},
                                        {ImGuiKey_Escape, GLFW_KEY_ESCAPE}}) {
            io.KeyMap[key] = code;
        }
        model.page.theme = &theme();
        model.page.unit = lanthorn::ui::unit_of(size, text_size);
        std::string missing;
        model.page.fonts = lanthorn::ui::load_fonts(theme(), model.page.unit, &missing);
        EXPECT_EQ(missing, "");
        lanthorn::ui::apply_style(theme(), model.page.unit);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        model.levels = {{"One"}, {"Two", nullptr, true}, {"Three"}, {"Four"}, {"Five"}, {"Six"}};
        model.screens.levels = 6;
        model.picture = {640, 360};
        model.keys.fill("K");
    }
    ~Player() { ImGui::DestroyContext(); }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    std::optional<Event> frame(const std::vector<int>& keys = {}, const PadState& pad = {}) {
        model.pressed.clear();
        for (const int key : keys) {
            model.pressed.push_back({Trigger::Device::keyboard, key});
        }
        for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
            if (pad.buttons[i] && !(model.pad && model.pad->buttons[i])) {
                model.pressed.push_back({Trigger::Device::pad, static_cast<int>(i)});
            }
        }
        model.pad = pad;
        lanthorn::ui::feed_gamepad(pad.buttons, pad.left_x, pad.left_y, ImGui::GetIO());
        if (held_ && !was_held_) {
            model.pressed.push_back({Trigger::Device::keyboard, *held_});
        }
        was_held_ = held_.has_value();
        keys_.feed(static_cast<int>(model.screens.at), !is_played(model.screens.at),
                   menu_keys(model.pressed, choices.bindings), [this](int key) { return held_ == key; });
        ImGui::NewFrame();
        page_.update(static_cast<int>(model.screens.at), model.page);
        const std::optional<Event> event = draw_screen(model, choices);
        ImGui::Render();
        return event;
    }
    // A tap shorter than a frame, and frames for what comes of it.
    std::optional<Event> key(int code) { return settled(frame({code})); }
    std::optional<Event> button(std::size_t code) {
        PadState pad;
        pad.buttons[code] = true;
        return settled(frame({}, pad));
    }
    // A frame of a key that stays down.
    void hold(int code) {
        held_ = code;
        frame();
        held_.reset();
    }
    void show(Screen screen) {
        model.screens.at = screen;
        for (int i = 0; i < 3; ++i) {
            frame();
        }
    }
    // Of what would be chosen now, in the window's pixels.
    ImRect chosen() const {
        const ImGuiContext& g = *ImGui::GetCurrentContext();
        ImRect rect = g.NavWindow->NavRectRel[0];
        rect.Translate(g.NavWindow->DC.CursorStartPos);
        return rect;
    }

    Model model;
    Choices choices;

  private:
    std::optional<Event> settled(std::optional<Event> event) {
        for (int i = 0; i < 3; ++i) {
            const std::optional<Event> later = frame();
            event = event ? event : later;
        }
        return event;
    }
    lanthorn::ui::PageState page_;
    lanthorn::ui::KeyQueue keys_;
    std::optional<int> held_;
    bool was_held_ = false;
};

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
