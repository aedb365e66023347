// Keyboard, mouse and gamepad as the simulation's input.
#pragma once

#include "game/player_input.h"

struct GLFWwindow;

namespace lanthorn::game {

class Devices {
  public:
    explicit Devices(GLFWwindow* window) : window_(window) {}

    // Reads the devices; call once a frame after glfwPollEvents(). `seconds` since the last call. While not
    // `playing` nothing reaches the player and the mouse is free.
    void poll(double seconds, bool playing);

    // How the player wants to look about: the mouse's turn is multiplied by `mouse`; `inverted`: forward looks
    // down, of the stick too.
    void set_look(double mouse, bool inverted) {
        mouse_ = mouse;
        up_ = inverted ? -1 : 1;
    }

    // Input for the next step. What the mouse turned since the last poll goes into the first step that asks.
    PlayerInput take();

    // Esc or Start went down since the last poll.
    bool menu_pressed() const { return menu_pressed_; }

  private:
    GLFWwindow* window_;
    PlayerInput held_;            // all but the turn
    double yaw_ = 0, pitch_ = 0;  // radians, waiting
    double mouse_ = 1, up_ = 1;
    double mouse_x_ = 0, mouse_y_ = 0;
    bool mouse_known_ = false;
    bool captured_ = false;
    bool menu_down_ = false;
    bool menu_pressed_ = false;
};

}  // namespace lanthorn::game
