#include "game/screens/key_queue.h"

#define GLFW_INCLUDE_NONE  // names of buttons alone
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>

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

void KeyQueue::add(const std::vector<Trigger>& pressed, const Bindings& bindings) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto places = static_cast<int>(std::size(io.KeysDown));
    for (const Trigger trigger : pressed) {
        const bool leaves = bindings.binds(trigger, Action::menu) && !chooses(trigger);
        const bool is_key = leaves || trigger.device == Trigger::Device::keyboard;
        const int code = leaves ? io.KeyMap[ImGuiKey_Escape] : trigger.code;
        if (is_key && code >= 0 && code < places && waiting_.size() < kMostWaiting) {
            waiting_.push_back(code);
        }
    }
}

void KeyQueue::next(const std::function<bool(int)>& is_down) {
    if (waiting_.empty() || settling_ > 0) {
        shown_ = shown_ != kNone && is_down(shown_) ? shown_ : kNone;
    } else if (shown_ != kNone) {
        shown_ = kNone;  // what a key does is done a frame later, as when Up leads around to the last entry
    } else {
        shown_ = waiting_.front();
        waiting_.pop_front();
    }
}

void KeyQueue::feed(Screen screen, const std::vector<Trigger>& pressed, const Bindings& bindings,
                    const std::function<bool(int)>& is_down) {
    // ImGui chooses a first entry in the frame that shows the screen, and takes keys from the next one on.
    settling_ = screen == screen_ ? std::max(settling_ - 1, 0) : 2;
    if (is_played(screen)) {
        waiting_.clear();
    } else if (!is_played(screen_)) {
        add(pressed, bindings);
    }
    screen_ = screen;
    next(is_down);
    ImGuiIO& io = ImGui::GetIO();
    std::ranges::fill(io.KeysDown, false);
    if (shown_ == kNone) {
        return;
    }
    io.KeysDown[shown_] = true;
    if (shown_ == io.KeyMap[ImGuiKey_Enter] || shown_ == io.KeyMap[ImGuiKey_KeyPadEnter]) {
        io.NavInputs[ImGuiNavInput_Activate] = 1;
    }
}

}  // namespace lanthorn::game::ui
