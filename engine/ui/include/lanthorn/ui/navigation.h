// Keys and a gamepad in the menus: what is pressed, as Dear ImGui takes it.
#pragma once

#include <imgui.h>

#include <bitset>
#include <deque>
#include <functional>
#include <span>

namespace lanthorn::ui {

// Keys on their way to the screens: one every other frame, so that what is typed faster than frames come
// keeps its order, and a key that goes down and up again within a frame counts.
class KeyQueue {
  public:
    // Says to ImGui which key is down in the frame that comes; call right before ImGui::NewFrame(), with what
    // went down since the frame before (`pressed`, keys by GLFW's numbers). `is_down` says of a key whether
    // it still is: it repeats then. ImGui 1.86 takes Space to choose; here Enter does so too. `screen`: a
    // number of the caller's for what is shown. On a new screen keys wait until it can take them.
    // `takes_keys`: false where keys are not for the screens; they are dropped there, and those of the first
    // frame after it.
    void feed(int screen, bool takes_keys, std::span<const int> pressed,
              const std::function<bool(int)>& is_down);

  private:
    static constexpr std::size_t kMostWaiting = 16;
    static constexpr int kNone = -1;
    void add(std::span<const int> pressed);
    void next(const std::function<bool(int)>& is_down);

    int screen_ = kNone;      // of the frame before
    bool took_keys_ = false;  // likewise
    int settling_ = 0;        // frames until it can be used
    std::deque<int> waiting_;
    int shown_ = kNone;
};

// Left stick and directional pad choose, A takes, B goes back.
// `buttons`: those that are down, by GLFW's numbers; `right`, `down`: the left stick's tilt, -1..1. Call
// before ImGui::NewFrame(), which forgets it in the end.
void feed_gamepad(const std::bitset<15>& buttons, double right, double down, ImGuiIO& io);

}  // namespace lanthorn::ui
