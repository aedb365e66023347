// From what happens at the devices to the states of actions, without a window.
#include "lanthorn/input/controls.h"

#include <gtest/gtest.h>

#include "tests/unit/input/acts.h"

namespace lanthorn::input {
namespace {

const Trigger kW = *find_trigger("W"), kE = *find_trigger("E"), kF = *find_trigger("F"),
              kEscape = *find_trigger("Escape"), kWheelUp = *find_trigger("Wheel Up");

void tap(Controls& controls, Trigger trigger) {
    controls.press(trigger);
    controls.release(trigger);
}

// Whether each of the next steps sees `mark`: "0110".
std::string steps(Controls& controls, std::uint32_t mark, int count) {
    std::string seen;
    for (int i = 0; i < count; ++i) {
        seen += (controls.take().marks & mark) != 0 ? '1' : '0';
    }
    return seen;
}

TEST(Controls, APressBetweenTwoFramesCountsForOneStep) {
    Controls controls(kActs);
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 4), "1000");
}

TEST(Controls, APressWaitsForAFrameThatHasAStep) {
    Controls controls(kActs);
    tap(controls, kE);
    controls.begin_frame(true);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 3), "100");
}

TEST(Controls, AKeyThatIsHeldIsPressedOnce) {
    Controls controls(kActs);
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 3), "111");
    controls.press(kE);  // a keyboard that repeats itself
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "11");
    controls.release(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "00");
}

TEST(Controls, TwoPressesBetweenTwoFramesAreTwo) {
    Controls controls(kActs);
    tap(controls, kE);
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 5), "10100");
}

TEST(Controls, LettingGoAndPressingAgainBetweenTwoFramesIsAPress) {
    Controls controls(kActs);
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "11");
    controls.release(kE);
    controls.press(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 3), "011");
}

TEST(Controls, OneKeyDoesNotHideAnother) {
    Controls controls(kActs);
    tap(controls, kE);
    tap(controls, kF);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().marks, kJump | kDuck);
    EXPECT_EQ(controls.take().marks, 0);
}

TEST(Controls, KeyAndPadAreOneAction) {
    Controls controls(kActs);
    PadState pad;
    pad.buttons[0] = true;  // A
    controls.press(kE);
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 3), "111");
    controls.release(kE);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "11");
}

TEST(Controls, AShortStepForwardIsAStep) {
    Controls controls(kActs);
    tap(controls, kW);
    controls.begin_frame(true);
    EXPECT_TRUE(controls.take().is_down(Act::forward));
    EXPECT_FALSE(controls.take().is_down(Act::forward));
}

TEST(Controls, EveryNotchOfTheWheelCountsUpToAFew) {
    Controls controls(kActs);
    tap(controls, kWheelUp);
    tap(controls, kWheelUp);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kLouder, 4), "1010");
    for (int i = 0; i < 100; ++i) {
        tap(controls, kWheelUp);
    }
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kLouder, 12), "101010100000");
}

TEST(Controls, EveryActionReachesTheStep) {
    Controls controls(kActs);
    for (std::size_t row = 0; row < std::size(kActs); ++row) {
        tap(controls, controls.bindings().of(row).front());
    }
    controls.begin_frame(true);
    const Step step = controls.take();
    EXPECT_EQ(step.marks, kJump | kDuck | kLouder);
    EXPECT_EQ(step.down, 0b11111u) << "menus reach no step";
    EXPECT_TRUE(controls.asked(Act::pause));
}

TEST(Controls, AStepTellsWhatBegins) {
    Controls controls(kActs);
    const Trigger jump = controls.bindings().of(Act::jump).front();
    controls.press(jump);
    controls.begin_frame(true);
    EXPECT_TRUE(controls.take().begins(Act::jump));
    const Step held = controls.take();
    EXPECT_TRUE(held.is_down(Act::jump));
    EXPECT_FALSE(held.begins(Act::jump));
    controls.release(jump);
    tap(controls, jump);
    controls.begin_frame(true);
    EXPECT_FALSE(controls.take().is_down(Act::jump));
    EXPECT_TRUE(controls.take().begins(Act::jump));
}

TEST(Controls, TwoActionsAreAnAxis) {
    Controls controls(kActs);
    const auto axis = [&] {
        controls.begin_frame(true);
        return controls.take().axis(Act::forward, Act::back);
    };
    EXPECT_EQ(axis(), 0);
    controls.press(controls.bindings().of(Act::back).front());
    EXPECT_EQ(axis(), -1);
    controls.press(controls.bindings().of(Act::forward).front());
    EXPECT_EQ(axis(), 0);
    controls.release(controls.bindings().of(Act::back).front());
    EXPECT_EQ(axis(), 1);
}

TEST(Controls, WhatWorksAlwaysReachesNoStepAndNeedsNoTrigger) {
    constexpr Action kTable[] = {{"picture", "keep a picture", "F12", Kind::always},
                                 {"jump", "jump", "J", Kind::pressed, 1}};
    Controls controls(kTable);
    tap(controls, *find_trigger("F12"));
    controls.begin_frame(false);
    EXPECT_TRUE(controls.asked(std::size_t{0}));
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().down, 0u);
    EXPECT_TRUE(
        read_bindings(kTable, R"({"picture": [], "jump": ["F12"]})", "keys.json").of(std::size_t{0}).empty());
}

TEST(Controls, TheMenuIsAskedForOnce) {
    Controls controls(kActs);
    tap(controls, kEscape);
    controls.begin_frame(true);
    EXPECT_TRUE(controls.asked(Act::pause));
    controls.begin_frame(true);
    EXPECT_FALSE(controls.asked(Act::pause));
    controls.press(kEscape);
    controls.begin_frame(false);
    EXPECT_TRUE(controls.asked(Act::pause));
    controls.begin_frame(false);
    EXPECT_FALSE(controls.asked(Act::pause));
}

TEST(Controls, NothingReachesThePlayerInTheMenu) {
    Controls controls(kActs);
    controls.begin_frame(true);
    tap(controls, kE);
    controls.turn_mouse(100, 100);
    controls.begin_frame(false);
    EXPECT_EQ(controls.take(), Step());
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), Step());
}

// Button A chooses "Resume" and is still down when play goes on: no door may open.
TEST(Controls, WhatChoseInTheMenuDoesNothingInTheGame) {
    Controls controls(kActs);
    PadState pad;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(false);
    pad.buttons[0] = true;
    controls.set_pad(pad, 0.01);
    controls.press(kW);
    controls.begin_frame(false);
    controls.begin_frame(true);
    EXPECT_TRUE(controls.take().is_down(Act::forward)) << "running goes on";
    EXPECT_EQ(steps(controls, kJump, 3), "000");
    pad.buttons[0] = false;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 1), "0");
    pad.buttons[0] = true;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "11");
}

TEST(Controls, APadThatIsPulledOutLetsGo) {
    Controls controls(kActs);
    PadState pad;
    pad.left_y = -1;
    pad.right_x = 1;
    pad.buttons[0] = true;
    pad.right_trigger = 1;
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    const Step with = controls.take();
    EXPECT_EQ(with.forward, 1);
    EXPECT_EQ(with.marks, kJump);
    EXPECT_LT(with.yaw, 0);
    controls.set_pad(std::nullopt, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), Step());
    controls.set_pad(pad, 0.01);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kJump, 2), "11");
}

TEST(Controls, TheStickHasSlack) {
    Controls controls(kActs);
    PadState pad;
    pad.left_x = 0.17;
    pad.right_y = -0.17;
    controls.set_pad(pad, 1);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take(), Step());
}

TEST(Controls, TheSticksAreAsChosen) {
    Controls plain(kActs), chosen(kActs);
    chosen.set_sticks(2, 0.5);
    PadState pad;
    pad.left_x = 0.4;
    pad.left_y = -0.75;
    pad.right_x = 1;
    for (Controls* controls : {&plain, &chosen}) {
        controls->set_pad(pad, 0.01);
        controls->begin_frame(true);
    }
    const Step a = plain.take(), b = chosen.take();
    EXPECT_NEAR(b.yaw, 2 * a.yaw, 1);
    EXPECT_GT(a.right, 0);
    EXPECT_EQ(b.right, 0);
    EXPECT_NEAR(b.forward, 0.5, 1e-12);
}

TEST(Controls, TheMouseTurnsTheFirstStepAndLosesNothing) {
    Controls controls(kActs);
    int turned = 0;
    for (int i = 0; i < 100; ++i) {
        controls.turn_mouse(-0.1, 0);
        controls.begin_frame(true);
        turned += controls.take().yaw;
        EXPECT_EQ(controls.take().yaw, 0);
    }
    EXPECT_NEAR(turned * kTurnUnit, 100 * 0.1 * 0.0022, kTurnUnit);
}

TEST(Controls, TheLookIsAsChosen) {
    Controls plain(kActs), chosen(kActs);
    chosen.set_look(2, true);
    for (Controls* controls : {&plain, &chosen}) {
        controls->turn_mouse(-50, -30);
        controls->begin_frame(true);
    }
    const Step a = plain.take(), b = chosen.take();
    EXPECT_GT(a.yaw, 0);
    EXPECT_GT(a.pitch, 0);
    EXPECT_NEAR(b.yaw, 2 * a.yaw, 1);
    EXPECT_NEAR(b.pitch, -2 * a.pitch, 1);
}

TEST(Controls, OtherBindingsStartAfresh) {
    Controls controls(kActs);
    controls.press(kE);
    controls.begin_frame(true);
    Bindings bindings(kActs);
    ASSERT_TRUE(bindings.bind(Act::duck, {kE}));
    controls.set_bindings(bindings);
    controls.begin_frame(true);
    EXPECT_EQ(steps(controls, kDuck, 1), "0");
    controls.release(kE);
    tap(controls, kE);
    controls.begin_frame(true);
    EXPECT_EQ(controls.take().marks, kDuck);
}

TEST(Controls, SayWhatWentDown) {
    Controls controls(kActs);
    tap(controls, kE);
    controls.press(kF);
    controls.begin_frame(false);
    EXPECT_EQ(controls.pressed(), (std::vector<Trigger>{kE, kF}));
    controls.begin_frame(false);
    EXPECT_TRUE(controls.pressed().empty());
}

TEST(Controls, SayWhatHappenedAndWhen) {
    Controls controls(kActs);
    controls.press(kE, 1.25);
    controls.press(kE, 1.3);  // a keyboard that repeats itself
    controls.release(kE, 1.5);
    controls.release(kF, 1.6);  // was not down
    controls.begin_frame(true);
    EXPECT_EQ(controls.events(), (std::vector<Event>{{kE, true, 1.25}, {kE, false, 1.5}}));
    controls.begin_frame(true);
    EXPECT_TRUE(controls.events().empty());
}

}  // namespace
}  // namespace lanthorn::input
