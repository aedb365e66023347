#include "game/screens/menu_keys.h"

#define GLFW_INCLUDE_NONE  // names of buttons alone
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "game/rules/actions.h"

namespace lanthorn::game::ui {

using input::Bindings;
using input::Trigger;

namespace {

// What the screens are used with, whatever it means while playing.
bool chooses(Trigger trigger) {
    switch (trigger.device) {
        case Trigger::Device::keyboard:
            return std::ranges::any_of(
                std::array{ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow,
                           ImGuiKey_Enter, ImGuiKey_KeyPadEnter, ImGuiKey_Space},
                [&](ImGuiKey key) { return ImGui::GetIO().KeyMap[key] == trigger.code; });
        case Trigger::Device::mouse:
            return trigger.code == GLFW_MOUSE_BUTTON_LEFT;
        case Trigger::Device::wheel:
            return true;
        case Trigger::Device::pad:
            // feed_gamepad() takes B for going back.
            return trigger.code == GLFW_GAMEPAD_BUTTON_A || trigger.code == GLFW_GAMEPAD_BUTTON_B ||
                   (trigger.code >= GLFW_GAMEPAD_BUTTON_DPAD_UP &&
                    trigger.code <= GLFW_GAMEPAD_BUTTON_DPAD_LEFT);
    }
    return false;
}

}  // namespace

std::vector<int> menu_keys(const std::vector<Trigger>& pressed, const Bindings& bindings) {
    std::vector<int> keys;
    for (const Trigger trigger : pressed) {
        const bool leaves = bindings.binds(trigger, Action::menu) && !chooses(trigger);
        if (leaves) {
            keys.push_back(ImGui::GetIO().KeyMap[ImGuiKey_Escape]);
        } else if (trigger.device == Trigger::Device::keyboard) {
            keys.push_back(trigger.code);
        }
    }
    return keys;
}

}  // namespace lanthorn::game::ui
