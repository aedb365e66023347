// Numbers as people type them.
#include "tools/editor/window/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn::edit_window {
namespace {

TEST(Quantity, SumsProductsBracketsAndUnits) {
    EXPECT_DOUBLE_EQ(typed_quantity("1.5*2")->value, 3);
    EXPECT_DOUBLE_EQ(typed_quantity(" 2 + 3 * (4 - 1) / 2 ")->value, 6.5);
    EXPECT_DOUBLE_EQ(typed_quantity("-.5")->value, -0.5);
    EXPECT_EQ(typed_quantity("800lm")->unit, "lm");
    EXPECT_EQ(typed_quantity("2700 K")->unit, "K");
    EXPECT_TRUE(std::isinf(typed_quantity("inf")->value));
    for (const char* bad : {"", " ", "lm", "1..2", "2 *", "(1", "1/0", "1 2", "1e999", "mixed"}) {
        EXPECT_FALSE(typed_quantity(bad)) << bad;
    }
    EXPECT_FALSE(typed_quantity(std::string(100'000, '(')));
}

TEST(Quantity, ConvertsToTheFieldsOwnUnit) {
    EXPECT_NEAR(*typed_number("45deg", "rad"), 0.785398, 1e-6);
    EXPECT_NEAR(*typed_number("1rad", "\u00b0"), 57.29578, 1e-5);
    EXPECT_DOUBLE_EQ(*typed_number("15cm", "m"), 0.15);
    EXPECT_DOUBLE_EQ(*typed_number("7", "m"), 7);
    EXPECT_FALSE(typed_number("7K", "m"));
}

TEST(Quantity, ShownWithNoMoreDigitsThanItNeeds) {
    EXPECT_EQ(shown_number(0), "0");
    EXPECT_EQ(shown_number(0.1), "0.1");
    EXPECT_EQ(shown_number(-2), "-2");
    EXPECT_EQ(shown_number(3896.4, 4), "3896");
    EXPECT_EQ(shown_number(1.0 / 3), "0.33333");
    EXPECT_EQ(shown_number(INFINITY), "infinite");
}

}  // namespace
}  // namespace lanthorn::edit_window
