#include "game/ui/gamepad_navigation.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace lanthorn::game::ui {

namespace {

constexpr float kDeadZone = 0.35f;  // a stick that lies a bit aside chooses nothing

float beyond_rest(float tilt) {
    return std::clamp((tilt - kDeadZone) / (1 - kDeadZone), 0.0f, 1.0f);
}

}  // namespace

void feed_gamepad(const GLFWgamepadstate& pad, ImGuiIO& io) {
    const auto button = [&](ImGuiNavInput input, int code) {
        if (pad.buttons[code] == GLFW_PRESS) {
            io.NavInputs[input] = 1;
        }
    };
    const auto tilt = [&](ImGuiNavInput input, float value) {
        io.NavInputs[input] = std::max(io.NavInputs[input], beyond_rest(value));
    };
    button(ImGuiNavInput_Activate, GLFW_GAMEPAD_BUTTON_A);
    button(ImGuiNavInput_Cancel, GLFW_GAMEPAD_BUTTON_B);
    button(ImGuiNavInput_DpadLeft, GLFW_GAMEPAD_BUTTON_DPAD_LEFT);
    button(ImGuiNavInput_DpadRight, GLFW_GAMEPAD_BUTTON_DPAD_RIGHT);
    button(ImGuiNavInput_DpadUp, GLFW_GAMEPAD_BUTTON_DPAD_UP);
    button(ImGuiNavInput_DpadDown, GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
    // The stick as a directional pad: ImGui would scroll with it.
    const float x = pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X], y = pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y];
    tilt(ImGuiNavInput_DpadLeft, -x);
    tilt(ImGuiNavInput_DpadRight, x);
    tilt(ImGuiNavInput_DpadUp, -y);
    tilt(ImGuiNavInput_DpadDown, y);
    io.BackendFlags |= ImGuiBackendFlags_HasGamepad;
}

}  // namespace lanthorn::game::ui
