#include <algorithm>

#include "lanthorn/ui/widgets.h"

namespace lanthorn::ui {

void PageState::update(int number, Page& page) {
    const ImGuiIO& io = ImGui::GetIO();
    page.appearing = number_ != number;
    seconds_ = page.appearing ? 0 : seconds_ + io.DeltaTime;
    number_ = number;
    page.shown_seconds = seconds_;
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseClicked[0]) {
        pointing_ = true;
    }
    // Where the mouse was left means nothing on a page that keys have led to; nor how it moved before it.
    if (page.appearing || std::ranges::any_of(io.NavInputs, [](float input) { return input > 0; })) {
        pointing_ = false;
    }
    page.pointing = pointing_;
}

}  // namespace lanthorn::ui
