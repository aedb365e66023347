#include "lanthorn/ui/navigation.h"

#define GLFW_INCLUDE_NONE  // names of buttons alone
#include <GLFW/glfw3.h>

#include <algorithm>

namespace lanthorn::ui {

namespace {

constexpr float kDeadZone = 0.35f;  // a stick that lies a bit aside chooses nothing

float beyond_rest(double tilt) {
    return std::clamp((static_cast<float>(tilt) - kDeadZone) / (1 - kDeadZone), 0.0f, 1.0f);
}

}  // namespace

void feed_gamepad(const std::bitset<15>& buttons, double right, double down, ImGuiIO& io) {
    const auto button = [&](ImGuiNavInput input, std::size_t code) {
        if (buttons[code]) {
            io.NavInputs[input] = 1;
        }
    };
    const auto tilt = [&](ImGuiNavInput input, double value) {
        io.NavInputs[input] = std::max(io.NavInputs[input], beyond_rest(value));
    };
    button(ImGuiNavInput_Activate, GLFW_GAMEPAD_BUTTON_A);
    button(ImGuiNavInput_Cancel, GLFW_GAMEPAD_BUTTON_B);
    button(ImGuiNavInput_DpadLeft, GLFW_GAMEPAD_BUTTON_DPAD_LEFT);
    button(ImGuiNavInput_DpadRight, GLFW_GAMEPAD_BUTTON_DPAD_RIGHT);
    button(ImGuiNavInput_DpadUp, GLFW_GAMEPAD_BUTTON_DPAD_UP);
    button(ImGuiNavInput_DpadDown, GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
    // The stick as a directional pad: ImGui would scroll with it.
    tilt(ImGuiNavInput_DpadLeft, -right);
    tilt(ImGuiNavInput_DpadRight, right);
    tilt(ImGuiNavInput_DpadUp, -down);
    tilt(ImGuiNavInput_DpadDown, down);
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableGamepad;
    io.BackendFlags |= ImGuiBackendFlags_HasGamepad;
}

}  // namespace lanthorn::ui
