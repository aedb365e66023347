// Keyboard, mouse and gamepad of a GLFW window as the simulation's input.
#pragma once

#include "game/presentation/controls.h"

struct GLFWwindow;

namespace lanthorn::game {

// Listens to the window's events and hands them on to who listened before (Dear ImGui, say). One a window,
// and gone before who listened before. A key that goes down and up again between two frames counts; a button
// of a gamepad must be down when poll() looks, for GLFW has no events of gamepads.
class Devices {
  public:
    explicit Devices(GLFWwindow* window);
    ~Devices();
    Devices(const Devices&) = delete;
    Devices& operator=(const Devices&) = delete;

    // Call once a frame after glfwPollEvents(). `seconds` since the last call. While not `playing` nothing
    // reaches the player and the mouse is free; nor does anything while the window has no focus.
    void poll(double seconds, bool playing);

    // See Controls.
    PlayerInput take() { return controls_.take(); }
    bool menu_pressed() const { return controls_.menu_pressed(); }

    void set_look(double mouse, bool inverted) { controls_.set_look(mouse, inverted); }

    // For bindings, and for what was pressed last.
    Controls& controls() { return controls_; }

  private:
    struct Listeners;  // what GLFW calls
    friend struct Listeners;

    GLFWwindow* window_;
    Controls controls_;
    bool captured_ = false;
    // The pointer's position has jumped, or is about to, without the mouse having moved.
    bool jumped_ = false;
    int unsettled_ = 0;  // calls of poll() until the pointer is where it belongs after a change of size
    double mouse_x_ = 0, mouse_y_ = 0;
    double scrolled_ = 0;  // notches, waiting for a whole one
};

}  // namespace lanthorn::game
