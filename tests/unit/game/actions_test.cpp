// The game's table of actions, and what comes from it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "game/presentation/control_words.h"
#include "game/rules/actions.h"
#include "lanthorn/core/error.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

using input::Bindings;
using input::find_trigger;

TEST(Actions, HaveTriggersAndWords) {
    const Bindings bindings = usual_bindings();
    for (std::size_t row = 0; row < actions().size(); ++row) {
        EXPECT_FALSE(bindings.of(row).empty()) << actions()[row].name;
        EXPECT_STRNE(actions()[row].words, "") << actions()[row].name;
    }
}

TEST(Actions, DeedsOfToursPressTheirButtons) {
    EXPECT_EQ(button_of(Deed::none), 0);
    EXPECT_EQ(button_of(Deed::use), kUse);
    EXPECT_EQ(button_of(Deed::light), kLight);
    EXPECT_EQ(button_of(Deed::carry), kCarry);
    EXPECT_EQ(button_of(Deed::brighter), kDimUp);
    EXPECT_EQ(button_of(Deed::darker), kDimDown);
    EXPECT_EQ(button_of(Deed::colour), kColour);
}

// What players have in their folders.
TEST(Actions, KeptFilesStayValid) {
    EXPECT_EQ(read_bindings(R"({"forward": ["W"], "back": ["S"], "left": ["A"], "right": ["D"],
        "use": ["E", "Pad A"], "light": ["F", "Pad X"], "carry": ["G", "Pad B"],
        "dim_up": ["R", "Wheel Up", "Pad Right Bumper"], "dim_down": ["T", "Wheel Down", "Pad Left Bumper"],
        "colour": ["C", "Pad Y"], "view": ["V", "Pad Right Stick"], "hint": ["H", "Pad Up"],
        "reset": ["Backspace", "Pad Back"], "menu": ["Escape", "Pad Start"]})",
                            "controls.json"),
              usual_bindings());
}

TEST(Actions, AFileOfANewerGameIsRefusedInOneLine) {
    try {
        read_bindings(R"({"use": ["E"], "swim": ["Q"]})", "controls.json");
        FAIL() << "accepted";
    } catch (const InputError& e) {
        EXPECT_EQ(
            std::string(e.what()),
            "controls.json: swim: is no action, expected one of forward, back, left, right, use, light, "
            "carry, dim_up, dim_down, colour, view, hint, reset, picture, menu");
    }
}

TEST(Actions, TheGuideHasTheirTable) {
    std::string table = "| while playing | keys and mouse | gamepad |\n|---|---|---|\n";
    for (const ControlWords& words : control_words()) {
        table += "| " + words.what + " | " + words.keys + " | " + words.pad + " |\n";
    }
    std::ifstream file(support::repository_file("docs/playing.md"));
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(table), std::string::npos) << "docs/playing.md needs this table:\n" << table;
}

}  // namespace
}  // namespace lanthorn::game
