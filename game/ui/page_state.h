// What a page has to know of the frames before: how long it has been there, and what it is used with.
#pragma once

#include <functional>
#include <optional>

#include "game/ui/model.h"

namespace lanthorn::game::ui {

class PageState {
  public:
    // Call once a frame between ImGui::NewFrame() and the page; fills in the model's members for it.
    void update(Model& model);

  private:
    std::optional<Screen> screen_;
    float seconds_ = 0;
    bool pointing_ = false;
};

// What ImGui 1.86 leaves out, to be called right before ImGui::NewFrame(): a key that went down and up again
// since the last frame counts (`pressed`: what went down), and Enter chooses as Space does.
void feed_keys(const std::vector<Trigger>& pressed);
// After the frame: `is_down` says of a key, as GLFW numbers it, whether it still is.
void release_keys(const std::vector<Trigger>& pressed, const std::function<bool(int)>& is_down);

}  // namespace lanthorn::game::ui
