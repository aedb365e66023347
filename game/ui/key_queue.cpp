#include "game/ui/key_queue.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace lanthorn::game::ui {

void KeyQueue::add(const std::vector<Trigger>& pressed) {
    const auto places = static_cast<int>(std::size(ImGui::GetIO().KeysDown));
    for (const Trigger trigger : pressed) {
        const bool is_key = trigger.device == Trigger::Device::keyboard;
        if (is_key && trigger.code >= 0 && trigger.code < places && waiting_.size() < kMostWaiting) {
            waiting_.push_back(trigger.code);
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

void KeyQueue::feed(Screen screen, const std::vector<Trigger>& pressed,
                    const std::function<bool(int)>& is_down) {
    // ImGui chooses a first entry in the frame that shows the screen, and takes keys from the next one on.
    settling_ = screen == screen_ ? std::max(settling_ - 1, 0) : 2;
    if (is_played(screen)) {
        waiting_.clear();
    } else if (!is_played(screen_)) {
        add(pressed);
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
