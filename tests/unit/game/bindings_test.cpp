#include "game/presentation/bindings.h"

#include <gtest/gtest.h>

#include <set>

#include "game/presentation/key_names.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {
namespace {

std::string refusal(const std::string& json) {
    try {
        read_bindings(json, "keys.json");
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

TEST(Bindings, EveryTriggerHasANameOfItsOwnThatFindsIt) {
    std::set<std::string> names;
    const auto check = [&](Trigger trigger) {
        const std::string name = name_of(trigger);
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(find_trigger(name), trigger) << name;
    };
    for (int key = 0; key <= 348; ++key) {
        check({Trigger::Device::keyboard, key});
    }
    for (int button = 0; button < 8; ++button) {
        check({Trigger::Device::mouse, button});
    }
    for (int button = 0; button < 15; ++button) {
        check({Trigger::Device::pad, button});
    }
    check({Trigger::Device::pad, kLeftTrigger});
    check({Trigger::Device::pad, kRightTrigger});
    check({Trigger::Device::wheel, 0});
    check({Trigger::Device::wheel, 1});
    EXPECT_EQ(names.count("E"), 1u);
    EXPECT_EQ(names.count("Left Shift"), 1u);
    EXPECT_EQ(names.count("?"), 0u);
    EXPECT_EQ(find_trigger("left shift"), find_trigger("Left Shift"));
    EXPECT_FALSE(find_trigger("F26") || find_trigger("") || find_trigger("Key 349") ||
                 find_trigger("Mouse 9"));
}

TEST(Bindings, ActionsAreListedInTheirOrder) {
    for (std::size_t i = 0; i < kActions; ++i) {
        EXPECT_EQ(static_cast<std::size_t>(actions()[i].action), i);
        EXPECT_FALSE(Bindings().of(actions()[i].action).empty()) << actions()[i].name;
    }
}

TEST(Bindings, NoTriggerMeansTwoThings) {
    const Bindings bindings;
    for (const ActionInfo& one : actions()) {
        for (const ActionInfo& other : actions()) {
            for (const Trigger trigger : bindings.of(one.action)) {
                EXPECT_EQ(bindings.binds(trigger, other.action), one.action == other.action)
                    << name_of(trigger);
            }
        }
    }
}

TEST(Bindings, ComeBackFromTheirFile) {
    Bindings bindings;
    EXPECT_TRUE(bindings.bind(Action::use, {*find_trigger("Space"), *find_trigger("Mouse Left")}));
    EXPECT_TRUE(bindings.bind(Action::hint, {}));
    EXPECT_NE(bindings, Bindings());
    EXPECT_EQ(read_bindings(bindings.to_json(), "keys.json"), bindings);
}

TEST(Bindings, WhatAFileDoesNotNameStays) {
    const Bindings read = read_bindings(R"({"use": ["Q", "pad a"]})", "keys.json");
    EXPECT_TRUE(read.binds(*find_trigger("Q"), Action::use));
    EXPECT_TRUE(read.binds(*find_trigger("Pad A"), Action::use));
    EXPECT_FALSE(read.binds(*find_trigger("E"), Action::use));
    EXPECT_TRUE(read.binds(*find_trigger("F"), Action::light));
}

// A file that is older than an action may have given away the key that the action comes with.
TEST(Bindings, WhatAFileGivesAwayIsNotAlsoAnUnnamedActions) {
    const Bindings read = read_bindings(R"({"use": ["V"]})", "keys.json");
    EXPECT_TRUE(read.binds(*find_trigger("V"), Action::use));
    EXPECT_FALSE(read.binds(*find_trigger("V"), Action::view));
    EXPECT_EQ(read.of(Action::view).size(), 1u) << "the gamepad's button is free";
    EXPECT_THROW(read_bindings(R"({"use": ["Escape", "pad start"]})", "keys.json"), InputError)
        << "the menu has none left";
}

TEST(Bindings, AKeyThatIsTakenMovesOver) {
    Bindings bindings;
    EXPECT_TRUE(bindings.bind(Action::use, {*find_trigger("F")}));
    EXPECT_TRUE(bindings.binds(*find_trigger("F"), Action::use));
    EXPECT_FALSE(bindings.binds(*find_trigger("F"), Action::light));
    EXPECT_TRUE(bindings.binds(*find_trigger("Pad X"), Action::light));
}

TEST(Bindings, TheMenuStaysInReach) {
    Bindings bindings;
    EXPECT_FALSE(bindings.bind(Action::menu, {}));
    EXPECT_FALSE(bindings.bind(Action::use, {*find_trigger("Escape"), *find_trigger("Pad Start")}));
    EXPECT_EQ(bindings, Bindings());
    EXPECT_EQ(refusal(R"({"menu": []})"), "keys.json: menu: found no key, expected at least one");
}

TEST(Bindings, ADamagedFileIsRefusedInOneLine) {
    EXPECT_EQ(refusal("{"), "keys.json: byte 2: is not JSON");
    EXPECT_EQ(refusal("[]"), "keys.json: found array, expected an object of actions");
    EXPECT_EQ(refusal(R"({"use": "E"})"), "keys.json: use: found string, expected a list of names of keys");
    EXPECT_EQ(refusal(R"({"use": ["Eh"]})"),
              "keys.json: use: found \"Eh\", expected a key, a mouse button or a gamepad button as \"E\", "
              "\"Mouse Left\" or \"Pad A\"");
    EXPECT_EQ(refusal(R"({"use": [5]})").substr(0, 22), "keys.json: use: found ");
    EXPECT_NE(refusal(R"({"jump": ["E"]})").find("jump: is no action, expected one of forward, back"),
              std::string::npos);
}

TEST(KeyNames, AreThoseOfTheDeviceInUse) {
    Bindings bindings;
    const auto name = [&](Action action, bool pad) {
        return key_names(bindings, pad)[static_cast<std::size_t>(action)];
    };
    EXPECT_EQ(name(Action::use, false), "E");
    EXPECT_EQ(name(Action::use, true), "A");
    EXPECT_EQ(name(Action::menu, false), "Esc");
    EXPECT_EQ(name(Action::menu, true), "Start");
    ASSERT_TRUE(bindings.bind(Action::use, {*find_trigger("Pad B")}));
    EXPECT_EQ(name(Action::use, false), "B") << "where nothing is bound there, the other device's";
    ASSERT_TRUE(bindings.bind(Action::use, {}));
    EXPECT_EQ(name(Action::use, true), "");
}

}  // namespace
}  // namespace lanthorn::game
