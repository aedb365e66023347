#include "lanthorn/ui/navigation.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace lanthorn::ui {

void KeyQueue::add(std::span<const int> pressed) {
    const auto places = static_cast<int>(std::size(ImGui::GetIO().KeysDown));
    for (const int key : pressed) {
        if (key >= 0 && key < places && waiting_.size() < kMostWaiting) {
            waiting_.push_back(key);
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

void KeyQueue::feed(int screen, bool takes_keys, std::span<const int> pressed,
                    const std::function<bool(int)>& is_down) {
    // ImGui chooses a first entry in the frame that shows the screen, and takes keys from the next one on.
    settling_ = screen == screen_ ? std::max(settling_ - 1, 0) : 2;
    if (!takes_keys) {
        waiting_.clear();
    } else if (took_keys_) {
        add(pressed);
    }
    screen_ = screen;
    took_keys_ = takes_keys;
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

}  // namespace lanthorn::ui
