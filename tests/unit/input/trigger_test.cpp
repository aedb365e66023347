#include "lanthorn/input/trigger.h"

#include <gtest/gtest.h>

#include <set>

namespace lanthorn::input {
namespace {

TEST(Triggers, EachHasANameOfItsOwnThatFindsIt) {
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

}  // namespace
}  // namespace lanthorn::input
