// Keys on their way to the screens: one every other frame, so that what is typed faster than frames come
// keeps its order, and a key that goes down and up again within a frame counts.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "game/screens/screens.h"
#include "lanthorn/input/bindings.h"

namespace lanthorn::game::ui {

class KeyQueue {
  public:
    // Says to ImGui which key is down in the frame that comes; call right before ImGui::NewFrame(), with what
    // went down since the frame before. `is_down` says of a key, as GLFW numbers it, whether it still is: it
    // repeats then. ImGui 1.86 takes Space to choose; here Enter does so too.
    // On a new screen keys wait until it can take them; what went down while playing is the player's.
    // The menu's keys and buttons come as Escape, but for those that choose on the screens.
    void feed(Screen screen, const std::vector<input::Trigger>& pressed, const input::Bindings& bindings,
              const std::function<bool(int)>& is_down);

  private:
    static constexpr std::size_t kMostWaiting = 16;
    static constexpr int kNone = -1;
    void add(const std::vector<input::Trigger>& pressed, const input::Bindings& bindings);
    void next(const std::function<bool(int)>& is_down);

    Screen screen_ = Screen::play;  // of the frame before
    int settling_ = 0;              // frames until it can be used
    std::deque<int> waiting_;
    int shown_ = kNone;
};

}  // namespace lanthorn::game::ui
