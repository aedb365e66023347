// The screens over the game's window.
#pragma once

#include <optional>

#include "game/screens/model.h"
#include "lanthorn/shell/kept_file.h"
#include "lanthorn/ui/navigation.h"
#include "lanthorn/ui/overlay.h"

struct GLFWwindow;

namespace lanthorn::game::ui {

class Interface {
  public:
    // The window's context must be current, for the destructor too. A font that is missing is said once.
    Interface(GLFWwindow* window, shell::Say say);

    // Draws the model's screen over the window's framebuffer of `size` pixels; returns what the player did
    // there, and changes `choices` as she does.
    std::optional<Event> draw(Model& model, Choices& choices, ivec2 size);

  private:
    void follow_size(ivec2 size, double text_size);
    void feed_devices(const Model& model, const input::Bindings& bindings);

    GLFWwindow* window_;
    lanthorn::ui::Overlay overlay_;
    shell::Say say_;
    lanthorn::ui::KeyQueue keys_;
    lanthorn::ui::PageState page_;
    lanthorn::ui::Fonts fonts_;
    float unit_ = 0;
    bool said_missing_ = false;
};

}  // namespace lanthorn::game::ui
