#include "game/screens/page_state.h"

#include <algorithm>

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

}  // namespace lanthorn::game::ui
