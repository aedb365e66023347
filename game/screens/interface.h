// The screens over the game's window: Dear ImGui with its backends for GLFW and OpenGL.
#pragma once

#include <optional>

#include "game/screens/key_queue.h"
#include "game/screens/page_state.h"
#include "lanthorn/shell/kept_file.h"

struct GLFWwindow;

namespace lanthorn::game::ui {

class Interface {
  public:
    // The window's context must be current, for the destructor too. A font that is missing is said once.
    Interface(GLFWwindow* window, shell::Say say);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    // Draws the model's screen over the window's framebuffer of `size` pixels; returns what the player did
    // there, and changes `choices` as she does.
    std::optional<Event> draw(Model& model, Choices& choices, ivec2 size);

  private:
    void follow_size(ivec2 size, double text_size);
    void feed_devices(const Model& model, const Bindings& bindings);

    GLFWwindow* window_;
    shell::Say say_;
    KeyQueue keys_;
    PageState page_;
    Fonts fonts_;
    float unit_ = 0;
    bool said_missing_ = false;
};

}  // namespace lanthorn::game::ui
