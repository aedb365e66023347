#include "lanthorn/input/bindings.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "tests/unit/input/acts.h"

namespace lanthorn::input {
namespace {

std::string refusal(const std::string& json) {
    try {
        read_bindings(kActs, json, "keys.json");
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

std::string refusal(std::span<const Action> table) {
    try {
        const Bindings bindings(table);
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

TEST(Bindings, AreTheTablesUnlessToldOtherwise) {
    const Bindings bindings(kActs);
    EXPECT_TRUE(bindings.binds(*find_trigger("Pad A"), Act::jump));
    EXPECT_TRUE(bindings.binds(*find_trigger("Wheel Up"), Act::louder));
    EXPECT_EQ(bindings.of(Act::jump).size(), 2u);
    EXPECT_EQ(bindings.of(Act::forward).size(), 1u);
}

TEST(Bindings, AWrongTableIsRefusedInOneLine) {
    const Action unknown[] = {{"jump", "", "E, Pad Z"}};
    EXPECT_EQ(refusal(unknown), "actions: jump: found trigger \"Pad Z\", expected names as \"E, Pad A\"");
    const Action twice[] = {{"jump", "", "E"}, {"jump", "", ""}};
    EXPECT_EQ(refusal(twice), "actions: jump: found twice, expected a name of its own");
    const Action same_key[] = {{"jump", "", "E"}, {"duck", "", "F, E"}};
    EXPECT_EQ(refusal(same_key), "actions: duck: found E, which \"jump\" has, expected triggers of its own");
    const Action shut[] = {{"pause", "", "", Kind::menu}};
    EXPECT_EQ(refusal(shut), "actions: pause: found no trigger, expected at least one");
    EXPECT_EQ(refusal(std::vector<Action>(65, Action{"jump", "", ""})),
              "actions: found 65 actions, expected at most 64");
    EXPECT_EQ(refusal(std::span<const Action>()), "accepted");
}

TEST(Bindings, ComeBackFromTheirFile) {
    Bindings bindings(kActs);
    EXPECT_TRUE(bindings.bind(Act::jump, {*find_trigger("Space"), *find_trigger("Mouse Left")}));
    EXPECT_TRUE(bindings.bind(Act::louder, {}));
    EXPECT_NE(bindings, Bindings(kActs));
    EXPECT_EQ(read_bindings(kActs, bindings.to_json(), "keys.json"), bindings);
}

TEST(Bindings, WhatAFileDoesNotNameStays) {
    const Bindings read = read_bindings(kActs, R"({"jump": ["Q", "pad a"]})", "keys.json");
    EXPECT_TRUE(read.binds(*find_trigger("Q"), Act::jump));
    EXPECT_TRUE(read.binds(*find_trigger("Pad A"), Act::jump));
    EXPECT_FALSE(read.binds(*find_trigger("E"), Act::jump));
    EXPECT_TRUE(read.binds(*find_trigger("F"), Act::duck));
}

// A file that is older than an action may have given away the key that the action comes with.
TEST(Bindings, WhatAFileGivesAwayIsNotAlsoAnUnnamedActions) {
    const Bindings read = read_bindings(kActs, R"({"jump": ["R"]})", "keys.json");
    EXPECT_TRUE(read.binds(*find_trigger("R"), Act::jump));
    EXPECT_FALSE(read.binds(*find_trigger("R"), Act::louder));
    EXPECT_EQ(read.of(Act::louder).size(), 1u) << "the wheel is free";
    EXPECT_THROW(read_bindings(kActs, R"({"jump": ["Escape", "pad start"]})", "keys.json"), InputError)
        << "the menu has none left";
}

TEST(Bindings, AKeyThatIsTakenMovesOver) {
    Bindings bindings(kActs);
    EXPECT_TRUE(bindings.bind(Act::jump, {*find_trigger("F")}));
    EXPECT_TRUE(bindings.binds(*find_trigger("F"), Act::jump));
    EXPECT_FALSE(bindings.binds(*find_trigger("F"), Act::duck));
    EXPECT_TRUE(bindings.binds(*find_trigger("Pad X"), Act::duck));
}

TEST(Bindings, TheMenuStaysInReach) {
    Bindings bindings(kActs);
    EXPECT_FALSE(bindings.bind(Act::pause, {}));
    EXPECT_FALSE(bindings.bind(Act::jump, {*find_trigger("Escape"), *find_trigger("Pad Start")}));
    EXPECT_EQ(bindings, Bindings(kActs));
    EXPECT_EQ(refusal(R"({"pause": []})"), "keys.json: pause: found no key, expected at least one");
}

TEST(Bindings, ADamagedFileIsRefusedInOneLine) {
    EXPECT_EQ(refusal("{"),
              "keys.json: JSON line 1, column 2: is not JSON: syntax error while parsing object key - "
              "unexpected end of input; expected string literal");
    EXPECT_EQ(refusal("[]"), "keys.json: found array, expected an object of actions");
    EXPECT_EQ(refusal(R"({"jump": "E"})"), "keys.json: jump: found string, expected a list of names of keys");
    EXPECT_EQ(refusal(R"({"jump": ["Eh"]})"),
              "keys.json: jump: found \"Eh\", expected a key, a mouse button or a gamepad button as \"E\", "
              "\"Mouse Left\" or \"Pad A\"");
    EXPECT_EQ(refusal(R"({"jump": [5]})").substr(0, 23), "keys.json: jump: found ");
    EXPECT_NE(refusal(R"({"fly": ["E"]})").find("fly: is no action, expected one of forward, back"),
              std::string::npos);
}

TEST(KeyNames, AreThoseOfTheDeviceInUse) {
    Bindings bindings(kActs);
    const auto name = [&](Act act, bool pad) { return key_name(bindings, act, pad); };
    EXPECT_EQ(name(Act::jump, false), "E");
    EXPECT_EQ(name(Act::jump, true), "A");
    EXPECT_EQ(name(Act::pause, false), "Esc");
    EXPECT_EQ(name(Act::pause, true), "Start");
    ASSERT_TRUE(bindings.bind(Act::jump, {*find_trigger("Pad B")}));
    EXPECT_EQ(name(Act::jump, false), "B") << "where nothing is bound there, the other device's";
    ASSERT_TRUE(bindings.bind(Act::jump, {}));
    EXPECT_EQ(name(Act::jump, true), "");
}

}  // namespace
}  // namespace lanthorn::input
