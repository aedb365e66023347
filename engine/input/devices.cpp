#include "lanthorn/input/devices.h"

#define GLFW_INCLUDE_NONE  // input alone
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace lanthorn::input {

namespace {

using Device = Trigger::Device;

// GLFW puts a captured pointer into the window's middle. Where that lies outside the screen the pointer gets
// as far as it can, a frame or two after the change of size, and GLFW takes its way there for the mouse's.
constexpr int kPollsToSettle = 8;

// The first gamepad there is, wherever GLFW has put it: one that is plugged in again may get another place.
std::optional<PadState> read_pad() {
    for (int place = GLFW_JOYSTICK_1; place <= GLFW_JOYSTICK_LAST; ++place) {
        GLFWgamepadstate state{};
        if (glfwGetGamepadState(place, &state) == GLFW_FALSE) {
            continue;
        }
        PadState pad;
        for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
            pad.buttons[i] = state.buttons[i] == GLFW_PRESS;
        }
        const auto axis = [&](int code) { return static_cast<double>(state.axes[code]); };
        pad.left_x = axis(GLFW_GAMEPAD_AXIS_LEFT_X);
        pad.left_y = axis(GLFW_GAMEPAD_AXIS_LEFT_Y);
        pad.right_x = axis(GLFW_GAMEPAD_AXIS_RIGHT_X);
        pad.right_y = axis(GLFW_GAMEPAD_AXIS_RIGHT_Y);
        pad.left_trigger = axis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
        pad.right_trigger = axis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
        return pad;
    }
    return std::nullopt;
}

}  // namespace

// GLFW calls plain functions, with the window alone to go by; its user pointer may be another's.
struct Devices::Listeners {
    Devices* devices;
    GLFWwindow* window;
    // Who listened before.
    GLFWkeyfun key_before;
    GLFWmousebuttonfun button_before;
    GLFWscrollfun scroll_before;
    GLFWcursorposfun position_before;
    GLFWcursorenterfun enter_before;
    GLFWwindowsizefun size_before;

    static inline std::vector<Listeners> all;  // one a window
    static const Listeners& of(GLFWwindow* window) {
        return *std::ranges::find(all, window, &Listeners::window);
    }

    static void change(GLFWwindow* window, Trigger trigger, int what) {
        Controls& controls = of(window).devices->controls_;
        if (what == GLFW_PRESS) {
            controls.press(trigger, glfwGetTime());
        } else if (what == GLFW_RELEASE) {
            controls.release(trigger, glfwGetTime());
        }
    }

    static void key(GLFWwindow* window, int code, int scancode, int what, int modifiers) {
        if (code != GLFW_KEY_UNKNOWN) {
            change(window, {Device::keyboard, code}, what);
        }
        if (const auto before = of(window).key_before) {
            before(window, code, scancode, what, modifiers);
        }
    }

    static void button(GLFWwindow* window, int code, int what, int modifiers) {
        change(window, {Device::mouse, code}, what);
        if (const auto before = of(window).button_before) {
            before(window, code, what, modifiers);
        }
    }

    static void scroll(GLFWwindow* window, double x, double y) {
        // Touchpads send parts of a notch.
        Devices& d = *of(window).devices;
        double& waiting = d.scrolled_;
        waiting += std::clamp(y, -100.0, 100.0);
        for (; std::abs(waiting) >= 1; waiting -= std::copysign(1, waiting)) {
            const Trigger notch{Device::wheel, waiting > 0 ? 0 : 1};
            d.controls_.press(notch, glfwGetTime());
            d.controls_.release(notch, glfwGetTime());
        }
        if (const auto before = of(window).scroll_before) {
            before(window, x, y);
        }
    }

    static void position(GLFWwindow* window, double x, double y) {
        Devices& d = *of(window).devices;
        const double right = x - std::exchange(d.mouse_x_, x);
        const double down = y - std::exchange(d.mouse_y_, y);
        const bool jumped = std::exchange(d.jumped_, false) || d.unsettled_ > 0;
        if (!jumped && d.captured_) {
            d.controls_.turn_mouse(right, down);
        }
        if (const auto before = of(window).position_before) {
            before(window, x, y);
        }
    }

    // The pointer comes into the window: GLFW (3.3) puts it where it came in, also while it counts the
    // mouse's way from where it was before. The next position says nothing of the mouse. It comes when play
    // begins with the pointer outside, for then GLFW fetches it.
    static void enter(GLFWwindow* window, int entered) {
        of(window).devices->jumped_ = true;
        if (const auto before = of(window).enter_before) {
            before(window, entered);
        }
    }

    static void size(GLFWwindow* window, int width, int height) {
        of(window).devices->unsettled_ = kPollsToSettle;
        if (const auto before = of(window).size_before) {
            before(window, width, height);
        }
    }
};

Devices::Devices(GLFWwindow* window, std::span<const Action> actions) : window_(window), controls_(actions) {
    Listeners::all.push_back({this, window_, glfwSetKeyCallback(window_, Listeners::key),
                              glfwSetMouseButtonCallback(window_, Listeners::button),
                              glfwSetScrollCallback(window_, Listeners::scroll),
                              glfwSetCursorPosCallback(window_, Listeners::position),
                              glfwSetCursorEnterCallback(window_, Listeners::enter),
                              glfwSetWindowSizeCallback(window_, Listeners::size)});
}

Devices::~Devices() {
    const Listeners listeners = Listeners::of(window_);
    glfwSetKeyCallback(window_, listeners.key_before);
    glfwSetMouseButtonCallback(window_, listeners.button_before);
    glfwSetScrollCallback(window_, listeners.scroll_before);
    glfwSetCursorPosCallback(window_, listeners.position_before);
    glfwSetCursorEnterCallback(window_, listeners.enter_before);
    glfwSetWindowSizeCallback(window_, listeners.size_before);
    std::erase_if(Listeners::all, [&](const Listeners& each) { return each.devices == this; });
}

void Devices::poll(double seconds, bool playing) {
    if (playing != captured_) {
        glfwSetInputMode(window_, GLFW_CURSOR, playing ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        captured_ = playing;
        jumped_ = true;
    }
    if (jumped_) {
        // Where the pointer is by now is where the mouse's way is counted from.
        glfwGetCursorPos(window_, &mouse_x_, &mouse_y_);
        jumped_ = false;
    }
    unsettled_ = std::max(unsettled_ - 1, 0);
    const bool focused = glfwGetWindowAttrib(window_, GLFW_FOCUSED) != 0;
    controls_.set_pad(focused ? read_pad() : std::nullopt, seconds, glfwGetTime());
    controls_.begin_frame(playing);
}

}  // namespace lanthorn::input
