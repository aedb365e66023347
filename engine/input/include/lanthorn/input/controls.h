// What a person does at keyboard, mouse and gamepad, as the states of actions in simulation steps. Knows no
// window: Devices feeds it from GLFW, tests and scripts by hand.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lanthorn/input/bindings.h"
#include "lanthorn/input/turn.h"

namespace lanthorn::input {

// A gamepad as it is held now.
struct PadState {
    std::bitset<15> buttons;  // by GLFW's numbers
    // Sticks in -1..1, to the right and down; triggers in -1..1, from loose to pressed.
    double left_x = 0, left_y = 0, right_x = 0, right_y = 0;
    double left_trigger = -1, right_trigger = -1;
};

// Of a stick's way, around its middle.
inline constexpr double kUsualDeadZone = 0.18;

// Something went down or up.
struct Event {
    Trigger trigger;
    bool down = false;
    double seconds = 0;  // when: on the clock of whoever told Controls

    bool operator==(const Event&) const = default;
};

// What a step sees.
struct Step {
    std::bitset<kMostActions> down;   // by row of the table; menus never are
    std::bitset<kMostActions> begun;  // of those, the ones that the step before did not see down
    std::uint32_t marks = 0;          // Action::mark of all that are down
    // The left stick, -1..1 to the right and forward, without the slack around its middle.
    double right = 0, forward = 0;
    // The view's turn since the last step in kTurnUnit, positive to the left and up. At most 4 radians a
    // step; the rest waits for the next one.
    std::int16_t yaw = 0, pitch = 0;

    // In the step, or pressed and released since the one before.
    bool is_down(ActionId action) const { return down[action.row()]; }
    // In this step: it was not down in the one before.
    bool begins(ActionId action) const { return begun[action.row()]; }
    // 1 while `plus` is down, -1 while `minus` is, 0 with both or none.
    double axis(ActionId plus, ActionId minus) const { return is_down(plus) - is_down(minus); }
    bool operator==(const Step&) const = default;
};

// A press lasts for a step at least, however short it was, and is seen once: two presses between two steps
// are two presses with a step between them.
class Controls {
  public:
    // With the table's own bindings; it must outlive this. Throws InputError as Bindings does.
    explicit Controls(std::span<const Action> actions);

    const Bindings& bindings() const { return bindings_; }  // what triggers mean now
    // Of the same table. Nothing counts as pressed until it is pressed anew.
    void set_bindings(Bindings bindings);
    // How the person wants to look about: the mouse's turn is multiplied by `mouse`; `inverted`: forward
    // looks down, of the stick too.
    void set_look(double mouse, bool inverted);

    // How the person's sticks are: at full tilt the view turns `speed` times as fast; up to a share of
    // `dead_zone` around their middle, 0 to below 1, they rest.
    void set_sticks(double speed, double dead_zone);

    // What happens at the devices, and when. Pressing what is down already does nothing.
    void press(Trigger trigger, double now = 0);
    // The end of a press, at `now` seconds. Nothing if it is not down; the action still gets its step.
    void release(Trigger trigger, double now = 0);
    void turn_mouse(double right, double down);  // pixels
    // The pad's state `seconds` after the one before. Nothing: there is none, or none any more.
    void set_pad(const std::optional<PadState>& pad, double seconds, double now = 0);

    // As it was told last.
    const std::optional<PadState>& pad() const { return pad_; }

    // Once a frame, after what happened since the last one. While not `playing` nothing reaches the steps,
    // and what is down when play goes on must be pressed anew, but for actions of Kind::held.
    void begin_frame(bool playing);

    // For the next step. What turned the view since the last frame goes into the first step that asks.
    Step take();

    // An action that reaches no step was pressed since the last frame.
    bool asked(ActionId menu) const { return asked_[menu.row()]; }
    // What happened since the last frame, in order, the shortest tap too.
    const std::vector<Event>& events() const { return events_; }
    // What of it went down: for a screen on which people choose keys.
    std::vector<Trigger> pressed() const;

  private:
    // An action between the devices and the steps.
    struct State {
        int waiting = 0;       // presses that no step has seen
        bool last = false;     // as the last step saw it
        bool ignored = false;  // down since before play went on
    };
    bool is_down(std::size_t row) const;
    bool next(std::size_t row);  // of a step

    Bindings bindings_;
    std::vector<Trigger> down_;
    std::vector<State> states_;  // by row
    std::optional<PadState> pad_;
    double mouse_ = 1, up_ = 1;
    double stick_ = 1, dead_zone_ = kUsualDeadZone;
    double yaw_ = 0, pitch_ = 0;  // radians, waiting
    bool playing_ = true;
    std::bitset<kMostActions> asked_;
    std::vector<Event> events_, events_next_;  // of the last frame, of the one that comes
};

}  // namespace lanthorn::input
