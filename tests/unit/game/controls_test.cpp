// From what happens at the devices to the input of the game's steps, without a window.
#include "lanthorn/input/controls.h"

#include <gtest/gtest.h>

#include "game/rules/actions.h"

namespace lanthorn::game {
namespace {

using input::find_trigger;
using input::PadState;

PlayerInput after(input::Controls& controls) {
    controls.begin_frame(true);
    return player_input(controls.take());
}

TEST(Controls, EveryActionReachesTheStep) {
    input::Controls controls(actions());
    for (std::size_t row = 0; row < kActions; ++row) {
        const input::Trigger trigger = controls.bindings().of(row).front();
        controls.press(trigger);
        controls.release(trigger);
    }
    EXPECT_EQ(after(controls).held,
              kUse | kLight | kCarry | kDimUp | kDimDown | kColour | kView | kHint | kReset);
    EXPECT_TRUE(controls.asked(Action::menu));
}

TEST(Controls, SheWalksWhereTheKeysSay) {
    for (const auto& [name, forward, right] :
         {std::tuple("W", 32767, 0), {"S", -32767, 0}, {"A", 0, -32767}, {"D", 0, 32767}}) {
        input::Controls controls(actions());
        controls.press(*find_trigger(name));
        const PlayerInput input = after(controls);
        EXPECT_EQ(input.forward, forward) << name;
        EXPECT_EQ(input.right, right) << name;
    }
    input::Controls controls(actions());
    controls.press(*find_trigger("W"));
    controls.press(*find_trigger("S"));
    EXPECT_EQ(after(controls).forward, 0);
}

TEST(Controls, TheStickWalksAsTheKeysDo) {
    input::Controls controls(actions());
    PadState pad;
    pad.left_x = 1;
    pad.left_y = -1;
    controls.set_pad(pad, 0.01);
    EXPECT_EQ(after(controls).forward, 32767);
    EXPECT_EQ(after(controls).right, 32767);
    controls.press(*find_trigger("W"));
    EXPECT_EQ(after(controls).forward, 32767) << "no faster with both";
}

TEST(Controls, TheMouseTurnsTheView) {
    input::Controls controls(actions());
    controls.turn_mouse(-10, 5);
    const PlayerInput input = after(controls);
    EXPECT_EQ(input.yaw, input::turn_units(10 * 0.0022));
    EXPECT_EQ(input.pitch, input::turn_units(-5 * 0.0022));
}

}  // namespace
}  // namespace lanthorn::game
