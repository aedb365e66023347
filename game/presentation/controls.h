// What the player does at keyboard, mouse and gamepad, as the input of simulation steps. Knows no window:
// Devices feeds it from GLFW, tests and scripts by hand.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "game/presentation/bindings.h"
#include "game/rules/player_input.h"

namespace lanthorn::game {

struct PadState {
    std::bitset<15> buttons;  // by GLFW's numbers
    // Sticks in -1..1, to the right and down; triggers in -1..1, from loose to pressed.
    double left_x = 0, left_y = 0, right_x = 0, right_y = 0;
    double left_trigger = -1, right_trigger = -1;
};

// A press lasts for a step at least, however short it was, and is seen once: two presses between two steps
// are two presses with a step between them.
class Controls {
  public:
    const Bindings& bindings() const { return bindings_; }
    // Nothing counts as pressed until it is pressed anew.
    void set_bindings(Bindings bindings);
    // How the player wants to look about: the mouse's turn is multiplied by `mouse`; `inverted`: forward
    // looks down, of the stick too.
    void set_look(double mouse, bool inverted);

    // What happens at the devices. Pressing what is down already does nothing.
    void press(Trigger trigger);
    void release(Trigger trigger);
    void turn_mouse(double right, double down);  // pixels
    // The pad's state `seconds` after the one before. Nothing: there is none, or none any more.
    void set_pad(const std::optional<PadState>& pad, double seconds);

    // As it was told last.
    const std::optional<PadState>& pad() const { return pad_; }

    // Once a frame, after what happened since the last one. While not `playing` nothing reaches the player,
    // and what is held down when play goes on must be pressed anew, but for walking.
    void begin_frame(bool playing);

    // Input for the next step. What turned the view since the last frame goes into the first step that asks.
    PlayerInput take();

    // The menu was asked for since the last frame.
    bool menu_pressed() const { return menu_pressed_; }
    // What went down since the last frame, in order: for a screen on which the player chooses keys.
    const std::vector<Trigger>& pressed() const { return pressed_; }

  private:
    // An action between the devices and the steps.
    struct State {
        int waiting = 0;       // presses that no step has seen
        bool last = false;     // as the last step saw it
        bool ignored = false;  // down since before play went on
    };
    State& state(Action action) { return states_[static_cast<std::size_t>(action)]; }
    bool down(Action action) const;
    bool next(Action action);  // of a step

    Bindings bindings_;
    std::vector<Trigger> down_;
    std::array<State, kActions> states_;
    std::optional<PadState> pad_;
    double mouse_ = 1, up_ = 1;
    double yaw_ = 0, pitch_ = 0;  // radians, waiting
    bool playing_ = true;
    bool menu_pressed_ = false;
    std::vector<Trigger> pressed_, pressed_next_;
};

}  // namespace lanthorn::game
