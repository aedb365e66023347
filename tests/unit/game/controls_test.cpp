// From what happens at the devices to the input of steps, without a window.
#include "game/presentation/controls.h"

#include <gtest/gtest.h>

namespace lanthorn::game {
namespace {

const Trigger kW = *find_trigger("W"), kS = *find_trigger("S"), kE = *find_trigger("E"),
              kF = *find_trigger("F"), kEscape = *find_trigger("Escape"),
              kWheelUp = *find_trigger("Wheel Up");

void tap(Controls& controls, Trigger trigger) {
    controls.press(trigger);
    controls.release(trigger);
}

// Whether each of the next steps sees `button` held down: "0110".
std::string steps(Controls& controls, Button button, int count) {
    std::string seen;
    for (int i = 0; i < count; ++i) {
        seen += (controls.take().held & button) != 0 ? '1' : '0';
    }
    return seen;
}

TEST(Controls, APressBetweenTwoFramesCountsForOneStep) {
    Controls controls;
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 4), "1000");
}

TEST(Controls, APressWaitsForAFrameThatHasAStep) {
    Controls controls;
    tap(controls, kE);
    controls.begin_frame(true);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 3), "100");
}

TEST(Controls, AKeyThatIsHeldIsPressedOnce) {
    Controls controls;
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 3), "111");
    controls.press(kE);  // a keyboard that repeats itself
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "11");
    controls.release(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "00");
}

TEST(Controls, TwoPressesBetweenTwoFramesAreTwo) {
    Controls controls;
    tap(controls, kE);
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 5), "10100");
}

TEST(Controls, LettingGoAndPressingAgainBetweenTwoFramesIsAPress) {
    Controls controls;
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "11");
    controls.release(kE);
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 3), "011");
}

TEST(Controls, OneKeyDoesNotHideAnother) {
    Controls controls;
    tap(controls, kE);
    tap(controls, kF);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().held, kUse | kLight);
    EXPECT_EQ(controls.take().held, 0);
}

TEST(Controls, KeyAndPadAreOneAction) {
    Controls controls;
    PadState pad;
    pad.buttons[0] = true;  // A
    controls.press(kE);
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 3), "111");
    controls.release(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "11");
}

TEST(Controls, AShortStepForwardIsAStep) {
    Controls controls;
    tap(controls, kW);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().forward, 32767);
    EXPECT_EQ(controls.take().forward, 0);
    controls.press(kW);
    controls.press(kS);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().forward, 0);
}

TEST(Controls, EveryNotchOfTheWheelCountsUpToAFew) {
    Controls controls;
    tap(controls, kWheelUp);
    tap(controls, kWheelUp);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kDimUp, 4), "1010");
    for (int i = 0; i < 100; ++i) {
        tap(controls, kWheelUp);
    }
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kDimUp, 12), "101010100000");
}

TEST(Controls, EveryActionReachesTheStep) {
    Controls controls;
    std::uint16_t held = 0;
    for (const ActionInfo& info : actions()) {
        tap(controls, controls.bindings().of(info.action).front());
    }
    controls.begin_frame(true);
    const PlayerInput input = controls.take();
    held = input.held;
    EXPECT_EQ(held, kUse | kLight | kCarry | kDimUp | kDimDown | kColour | kView | kHint | kReset);
    EXPECT_TRUE(controls.menu_pressed());
}

TEST(Controls, TheMenuIsAskedForOnce) {
    Controls controls;
    tap(controls, kEscape);
    controls.begin_frame(true);
    EXPECT_TRUE(controls.menu_pressed());
    controls.begin_frame(true);
    EXPECT_FALSE(controls.menu_pressed());
    controls.press(kEscape);
    controls.begin_frame(false);
    EXPECT_TRUE(controls.menu_pressed());
    controls.begin_frame(false);
    EXPECT_FALSE(controls.menu_pressed());
}

TEST(Controls, NothingReachesThePlayerInTheMenu) {
    Controls controls;
    controls.begin_frame(true);
    tap(controls, kE);
    controls.turn_mouse(100, 100);
    controls.begin_frame(false);
    EXPECT_EQ(controls.take(), PlayerInput());
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), PlayerInput());
}

// Button A chooses "Resume" and is still down when play goes on: no door may open.
TEST(Controls, WhatChoseInTheMenuDoesNothingInTheGame) {
    Controls controls;
    PadState pad;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(false);
    pad.buttons[0] = true;
    controls.set_pad(pad, 0.01);
    controls.press(kW);
    controls.begin_frame(false);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().forward, 32767);  // walking goes on
    EXPECT_EQ(steps(controls, kUse, 3), "000");
    pad.buttons[0] = false;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 1), "0");
    pad.buttons[0] = true;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "11");
}

TEST(Controls, APadThatIsPulledOutLetsGo) {
    Controls controls;
    PadState pad;
    pad.left_y = -1;
    pad.right_x = 1;
    pad.buttons[0] = true;
    pad.right_trigger = 1;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    const PlayerInput with = controls.take();
    EXPECT_EQ(with.forward, 32767);
    EXPECT_EQ(with.held, kUse);
    EXPECT_LT(with.yaw, 0);
    controls.set_pad(std::nullopt, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), PlayerInput());
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kUse, 2), "11");
}

TEST(Controls, TheStickHasSlack) {
    Controls controls;
    PadState pad;
    pad.left_x = 0.17;
    pad.right_y = -0.17;
    controls.set_pad(pad, 1);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), PlayerInput());
}

TEST(Controls, TheMouseTurnsTheFirstStepAndLosesNothing) {
    Controls controls;
    int turned = 0;
    for (int i = 0; i < 100; ++i) {
        controls.turn_mouse(-0.1, 0);
        controls.begin_frame(true);
        turned += controls.take().yaw;
        EXPECT_EQ(controls.take().yaw, 0);
    }
    EXPECT_NEAR(turned * kLookUnit, 100 * 0.1 * 0.0022, kLookUnit);
}

TEST(Controls, TheLookIsAsChosen) {
    Controls plain, chosen;
    chosen.set_look(2, true);
    for (Controls* controls : {&plain, &chosen}) {
        controls->turn_mouse(-50, -30);
        controls->begin_frame(true);
    }
    const PlayerInput a = plain.take(), b = chosen.take();
    EXPECT_GT(a.yaw, 0);
    EXPECT_GT(a.pitch, 0);
    EXPECT_NEAR(b.yaw, 2 * a.yaw, 1);
    EXPECT_NEAR(b.pitch, -2 * a.pitch, 1);
}

TEST(Controls, OtherBindingsStartAfresh) {
    Controls controls;
    controls.press(kE);
    controls.begin_frame(true);
    Bindings bindings;
    ASSERT_TRUE(bindings.bind(Action::light, {kE}));
    controls.set_bindings(bindings);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kLight, 1), "0");
    controls.release(kE);
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().held, kLight);
}

TEST(Controls, SayWhatWentDown) {
    Controls controls;
    tap(controls, kE);
    controls.press(kF);
    controls.begin_frame(false);
    EXPECT_EQ(controls.pressed(), (std::vector<Trigger>{kE, kF}));
    controls.begin_frame(false);
    EXPECT_TRUE(controls.pressed().empty());
}

}  // namespace
}  // namespace lanthorn::game
