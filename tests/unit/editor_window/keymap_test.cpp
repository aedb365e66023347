// Which keys do what.
#include "tools/editor/window/keymap.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {
namespace {

constexpr int kShift = 1, kCtrl = 2, kAlt = 4;  // GLFW's

TEST(Keymap, NoKeyHasTwoMeanings) {
    for (const Keymap keymap : {Keymap::standard, Keymap::blender}) {
        std::set<std::pair<int, int>> keys;
        for (const KeyBinding& binding : bindings(keymap)) {
            for (int i = 0; i < binding.count; ++i) {
                EXPECT_TRUE(keys.insert({binding.key + i, binding.modifiers}).second) << binding.words;
                EXPECT_EQ(static_cast<int>(act_of(keymap, binding.key + i, binding.modifiers)),
                          static_cast<int>(binding.act) + i);
            }
            EXPECT_FALSE(key_name(binding).empty());
        }
    }
    EXPECT_EQ(key_name(Keymap::standard, Act::save_as), "Ctrl+Shift+S");
    EXPECT_EQ(act_of(Keymap::standard, 'J', 0), Act::none);
}

TEST(Keymap, DigitsAreKeptViewsByNumber) {
    EXPECT_EQ(view_number(act_of(Keymap::standard, '1', 0), Act::go_to_view), 1);
    EXPECT_EQ(view_number(act_of(Keymap::standard, '9', 0), Act::go_to_view), 9);
    EXPECT_EQ(view_number(act_of(Keymap::standard, '9', kCtrl), Act::keep_view), 9);
    EXPECT_EQ(view_number(act_of(Keymap::standard, '9', kCtrl), Act::go_to_view), 0);
    EXPECT_EQ(view_number(Act::view_before, Act::keep_view), 0);
    EXPECT_EQ(act_of(Keymap::standard, '0', kCtrl), Act::usual_text);
    EXPECT_EQ(act_of(Keymap::standard, '3', kAlt), Act::view_indirect);
    EXPECT_EQ(key_name(Keymap::standard, static_cast<Act>(static_cast<int>(Act::keep_view) + 4)), "Ctrl+5");
    for (const KeyBinding& binding : bindings(Keymap::standard)) {
        if (binding.act == Act::keep_view) {
            EXPECT_EQ(key_name(binding), "Ctrl+1 to 9");
        }
    }
}

TEST(Keymap, BlenderActsAtOnceAndLosesNoActButTheToolsThatItsKeysReplace) {
    EXPECT_EQ(act_of(Keymap::standard, 'G', 0), Act::check_game);
    EXPECT_EQ(act_of(Keymap::blender, 'G', 0), Act::move_now);
    EXPECT_EQ(act_of(Keymap::blender, 'R', 0), Act::rotate_now);
    EXPECT_EQ(act_of(Keymap::blender, 'S', 0), Act::scale_now);
    EXPECT_EQ(act_of(Keymap::blender, 'Z', kCtrl), Act::undo);
    EXPECT_EQ(key_name(Keymap::blender, Act::duplicate), "Shift+D");
    for (const KeyBinding& binding : bindings(Keymap::standard)) {
        const bool replaced = binding.act == Act::tool_scale || binding.act == Act::axis_x;
        EXPECT_EQ(key_name(Keymap::blender, binding.act).empty(), replaced) << binding.words;
    }
    EXPECT_EQ(act_of(Keymap::blender, 'G', kShift), Act::check_game);
}

TEST(Keymap, IsKeptByItsName) {
    for (const Keymap keymap : {Keymap::standard, Keymap::blender}) {
        EXPECT_EQ(keymap_named(std::string(name_of(keymap)) + "\n", "keys"), keymap);
    }
    try {
        keymap_named("emacs\n", "keys");
        FAIL() << "no such keymap";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "keys: line 1: found 'emacs', expected standard or blender");
    }
}

}  // namespace
}  // namespace lanthorn::edit_window
