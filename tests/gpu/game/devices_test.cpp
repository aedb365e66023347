// Keyboard and mouse of a real window, on an X server of its own without a window manager. xdotool moves
// them.
#include "lanthorn/input/devices.h"

#include <gtest/gtest.h>

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

#include "game/rules/actions.h"
#include "lanthorn/gpu/window_context.h"

namespace lanthorn::game {
namespace {

using input::Trigger;
using input::turn_units;

void xdotool(const std::string& commands) {
    ASSERT_EQ(std::system(("xdotool " + commands).c_str()), 0) << commands;
}

class DevicesInAWindow : public testing::Test {
  protected:
    void open() {
        window_.emplace("devices", ivec2(640, 360), false);
        devices_.emplace(window_->handle(), actions());
        glfwPollEvents();
        settle();
    }

    // Until everything that was done so far has arrived: what the server sends comes in order. One frame of
    // the game, without a step.
    void settle() {
        const Trigger last = *input::find_trigger("F12");
        bool arrived = false;
        devices_->poll(0, playing_);
        xdotool("key F12");
        for (int i = 0; i < 100 && !arrived; ++i) {
            glfwWaitEventsTimeout(0.1);
            devices_->poll(0, playing_);
            const std::vector<Trigger>& pressed = devices_->controls().pressed();
            arrived = std::ranges::find(pressed, last) != pressed.end();
            menu_ = menu_ || devices_->asked(Action::menu);
        }
        ASSERT_TRUE(arrived);
    }

    PlayerInput take() { return player_input(devices_->take()); }

    std::optional<gpu::WindowContext> window_;
    std::optional<input::Devices> devices_;
    bool playing_ = true;
    bool menu_ = false;  // was asked for
};

TEST_F(DevicesInAWindow, TheViewStaysWhenTheGameBeginsWithThePointerElsewhere) {
    xdotool("mousemove 1200 900");
    open();
    EXPECT_EQ(take(), PlayerInput());

    xdotool("mousemove_relative -- -10 5");
    settle();
    const PlayerInput turned = take();
    EXPECT_EQ(turned.yaw, turn_units(10 * 0.0022));
    EXPECT_EQ(turned.pitch, turn_units(-5 * 0.0022));
    EXPECT_EQ(take(), PlayerInput());
}

TEST_F(DevicesInAWindow, TheViewStaysWhenTheGameGoesOnWithThePointerElsewhere) {
    xdotool("mousemove 320 180");
    open();
    playing_ = false;
    settle();
    xdotool("mousemove 1200 900");
    settle();
    playing_ = true;
    settle();
    EXPECT_EQ(take(), PlayerInput());
    playing_ = false;
    settle();
    xdotool("mousemove 30 40");  // within the window, away from its middle
    settle();
    playing_ = true;
    settle();
    EXPECT_EQ(take(), PlayerInput());
}

TEST_F(DevicesInAWindow, WhatTheMouseTurnedBeforeTheMenuIsNotTurnedAgain) {
    open();
    for (int i = 0; i < 3; ++i) {
        xdotool("mousemove_relative -- 100 20");
        settle();
    }
    EXPECT_NEAR(take().yaw, turn_units(-300 * 0.0022), 2);
    playing_ = false;
    settle();
    playing_ = true;
    settle();
    xdotool("mousemove_relative -- 10 0");
    settle();
    EXPECT_EQ(take().yaw, turn_units(-10 * 0.0022));
}

TEST_F(DevicesInAWindow, ATapBetweenTwoFramesIsAPress) {
    open();
    for (int i = 0; i < 3; ++i) {
        xdotool("key e");
        settle();
        EXPECT_EQ(take().held, kUse);
        EXPECT_EQ(take().held, 0);
    }
    xdotool("key f key f click 4");
    settle();
    EXPECT_EQ(take().held, kLight | kDimUp);
    EXPECT_EQ(take().held, 0);
    EXPECT_EQ(take().held, kLight);
    EXPECT_EQ(take().held, 0);
    EXPECT_FALSE(menu_);
    xdotool("key Escape");
    settle();
    EXPECT_TRUE(menu_);
}

TEST_F(DevicesInAWindow, AWindowThatLosesTheFocusLetsGo) {
    open();
    xdotool("keydown w keydown e");
    settle();
    EXPECT_EQ(take().forward, 32767);
    EXPECT_EQ(take().held, kUse);

    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* other = glfwCreateWindow(100, 100, "other", nullptr, nullptr);
    ASSERT_NE(other, nullptr);
    glfwFocusWindow(other);
    for (int i = 0; i < 100 && glfwGetKey(window_->handle(), GLFW_KEY_E) == GLFW_PRESS; ++i) {
        glfwWaitEventsTimeout(0.1);
    }
    devices_->poll(0, true);
    EXPECT_EQ(take(), PlayerInput());

    xdotool("mousemove 1100 800 keyup w keyup e");
    glfwDestroyWindow(other);
    glfwFocusWindow(window_->handle());
    settle();
    EXPECT_EQ(take(), PlayerInput());
}

// Its middle, where GLFW would have the pointer, lies outside the screen.
TEST_F(DevicesInAWindow, TheViewStaysWhenTheWindowOutgrowsTheScreen) {
    open();
    for (const ivec2 size : {ivec2(3840, 2160), ivec2(200, 100), ivec2(3840, 2160), ivec2(640, 360)}) {
        glfwSetWindowSize(window_->handle(), size.x, size.y);
        settle();
        EXPECT_EQ(take(), PlayerInput()) << size.x;
    }
    for (int i = 0; i < 8; ++i) {
        settle();
    }
    xdotool("mousemove_relative -- -10 -5");
    settle();
    EXPECT_EQ(take().yaw, turn_units(10 * 0.0022));
}

TEST_F(DevicesInAWindow, WhoListenedBeforeStillHears) {
    window_.emplace("devices", ivec2(640, 360), false);
    static int heard = 0;
    glfwSetKeyCallback(window_->handle(), [](GLFWwindow*, int, int, int, int) { ++heard; });
    devices_.emplace(window_->handle(), actions());
    settle();
    EXPECT_GE(heard, 1);
    devices_.reset();
    EXPECT_NE(glfwSetKeyCallback(window_->handle(), nullptr), nullptr);
}

}  // namespace
}  // namespace lanthorn::game
