// What a page has to know of the frames before: how long it has been there, and what it is used with.
#pragma once

#include <optional>

#include "game/screens/model.h"

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

}  // namespace lanthorn::game::ui
