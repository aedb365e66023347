// Keyboard, mouse and gamepad of a GLFW window as a program's actions: the header of this library that a
// program with a window includes.
//
//   enum class Act { forward, jump, menu };
//   constexpr input::Action kActs[] = {{"forward", "run forward", "W, Up", input::Kind::held},
//                                      {"jump", "jump", "Space, Pad A"},
//                                      {"menu", "menu", "Escape, Pad Start", input::Kind::menu}};
//   input::Devices devices(window.handle(), kActs);
//   while (!done) {
//       glfwPollEvents();
//       devices.poll(seconds, !paused);
//       paused = paused != devices.asked(Act::menu);
//       for (int i = 0; i < steps; ++i) {
//           const input::Step step = devices.take();
//           simulate(step.is_down(Act::forward), step.is_down(Act::jump), step.yaw * input::kTurnUnit);
//       }
//   }
#pragma once

#include <span>

#include "lanthorn/input/controls.h"

struct GLFWwindow;

namespace lanthorn::input {

// Listens to the window's events and hands them on to who listened before (Dear ImGui, say). One a window,
// and gone before who listened before. A key that goes down and up again between two frames counts; a button
// of a gamepad must be down when poll() looks, for GLFW has no events of gamepads.
class Devices {
  public:
    // The table must outlive this. Throws InputError as Bindings does.
    Devices(GLFWwindow* window, std::span<const Action> actions);
    ~Devices();
    Devices(const Devices&) = delete;
    Devices& operator=(const Devices&) = delete;

    // Call once a frame after glfwPollEvents(). `seconds` since the last call. While not `playing` nothing
    // reaches the steps and the mouse is free; nor does anything while the window has no focus.
    void poll(double seconds, bool playing);

    // See Controls.
    Step take() { return controls_.take(); }
    bool asked(ActionId menu) const { return controls_.asked(menu); }  // see Controls::asked

    // See Controls::set_look.
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

}  // namespace lanthorn::input
