#include "game/devices.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <cmath>

namespace lanthorn::game {

namespace {

constexpr double kMouseRadians = 0.0022;  // a pixel
constexpr double kStickRadians = 2.6;     // a second, at full tilt
constexpr double kDeadZone = 0.18;

// A stick's axis without the slack around its middle.
double tilt(float value) {
    const double size = std::abs(value);
    return size < kDeadZone ? 0 : std::copysign((size - kDeadZone) / (1 - kDeadZone), value);
}

}  // namespace

void Devices::poll(double seconds, bool playing) {
    const auto key = [&](int code) { return glfwGetKey(window_, code) == GLFW_PRESS; };
    GLFWgamepadstate pad{};
    const bool has_pad = glfwGetGamepadState(GLFW_JOYSTICK_1, &pad) == GLFW_TRUE;
    const auto button = [&](int code) { return has_pad && pad.buttons[code] == GLFW_PRESS; };

    const bool menu = key(GLFW_KEY_ESCAPE) || button(GLFW_GAMEPAD_BUTTON_START);
    menu_pressed_ = menu && !menu_down_;
    menu_down_ = menu;

    if (playing != captured_) {
        glfwSetInputMode(window_, GLFW_CURSOR, playing ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        captured_ = playing;
        mouse_known_ = false;
    }
    held_ = {};
    if (!playing) {
        yaw_ = pitch_ = 0;
        return;
    }

    double x = 0, y = 0;
    glfwGetCursorPos(window_, &x, &y);
    if (mouse_known_) {
        yaw_ -= (x - mouse_x_) * mouse_ * kMouseRadians;
        pitch_ -= (y - mouse_y_) * mouse_ * up_ * kMouseRadians;
    }
    mouse_x_ = x;
    mouse_y_ = y;
    mouse_known_ = true;

    double forward = key(GLFW_KEY_W) - key(GLFW_KEY_S) + 0.0;
    double right = key(GLFW_KEY_D) - key(GLFW_KEY_A) + 0.0;
    if (has_pad) {
        right += tilt(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
        forward -= tilt(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
        yaw_ -= tilt(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]) * kStickRadians * seconds;
        pitch_ -= tilt(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]) * up_ * kStickRadians * seconds;
    }
    held_.forward = axis(forward);
    held_.right = axis(right);
    const auto hold = [&](Button b, bool down) {
        if (down) {
            held_.held = static_cast<std::uint16_t>(held_.held | b);
        }
    };
    hold(kUse, key(GLFW_KEY_E) || button(GLFW_GAMEPAD_BUTTON_A));
    hold(kLight, key(GLFW_KEY_F) || button(GLFW_GAMEPAD_BUTTON_X));
    hold(kCarry, key(GLFW_KEY_G) || button(GLFW_GAMEPAD_BUTTON_B));
}

PlayerInput Devices::take() {
    PlayerInput input = held_;
    input.yaw = look(yaw_);
    input.pitch = look(pitch_);
    // What rounding left over waits for the next step.
    yaw_ -= input.yaw * kLookUnit;
    pitch_ -= input.pitch * kLookUnit;
    return input;
}

}  // namespace lanthorn::game
