#include "game/ui/page_state.h"

#include <algorithm>
#include <iterator>

namespace lanthorn::game::ui {

void PageState::update(Model& model) {
    const ImGuiIO& io = ImGui::GetIO();
    model.appearing = screen_ != model.screens.at;
    seconds_ = model.appearing ? 0 : seconds_ + io.DeltaTime;
    screen_ = model.screens.at;
    model.shown_seconds = seconds_;
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseClicked[0]) {
        pointing_ = true;
    }
    // Where the mouse was left means nothing on a page that keys have led to.
    if (std::ranges::any_of(io.NavInputs, [](float input) { return input > 0; })) {
        pointing_ = false;
    }
    model.pointing = pointing_;
}

namespace {

// Its place in ImGuiIO::KeysDown; null: it has none.
bool* key_down(Trigger trigger) {
    ImGuiIO& io = ImGui::GetIO();
    const bool has_place = trigger.device == Trigger::Device::keyboard && trigger.code >= 0 &&
                           static_cast<std::size_t>(trigger.code) < std::size(io.KeysDown);
    return has_place ? &io.KeysDown[trigger.code] : nullptr;
}

}  // namespace

void feed_keys(const std::vector<Trigger>& pressed) {
    ImGuiIO& io = ImGui::GetIO();
    for (const Trigger trigger : pressed) {
        if (bool* down = key_down(trigger)) {
            *down = true;
        }
    }
    for (const ImGuiKey key : {ImGuiKey_Enter, ImGuiKey_KeyPadEnter}) {
        const int code = io.KeyMap[key];
        if (code >= 0 && io.KeysDown[code]) {
            io.NavInputs[ImGuiNavInput_Activate] = 1;
        }
    }
}

void release_keys(const std::vector<Trigger>& pressed, const std::function<bool(int)>& is_down) {
    for (const Trigger trigger : pressed) {
        if (bool* down = key_down(trigger)) {
            *down = is_down(trigger.code);
        }
    }
}

}  // namespace lanthorn::game::ui
