// A gamepad in the menus, without a window.
#include "lanthorn/ui/navigation.h"

#include <gtest/gtest.h>

namespace lanthorn::ui {
namespace {

TEST(GamepadNavigation, ButtonATakes) {
    ImGuiIO io;
    feed_gamepad({}, 0, 0, io);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_Activate], 0);
    feed_gamepad(1, 0, 0, io);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_Activate], 1);
}

TEST(GamepadNavigation, AStickAtRestChoosesNothing) {
    ImGuiIO io;
    feed_gamepad({}, 0.3, -0.3, io);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_DpadRight], 0);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_DpadUp], 0);
    feed_gamepad({}, 1, -1, io);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_DpadRight], 1);
    EXPECT_EQ(io.NavInputs[ImGuiNavInput_DpadUp], 1);
}

}  // namespace
}  // namespace lanthorn::ui
