#include "lanthorn/input/controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanthorn::input {

namespace {

constexpr double kMouseRadians = 0.0022;  // a pixel
constexpr double kStickRadians = 2.6;     // a second, at full tilt
// Presses that wait for a step. The wheel can send more than the steps of a frame take: what goes on long
// after the hand has stopped helps nobody.
constexpr int kMostWaiting = 4;

// A stick's axis without the slack around its middle.
double tilt(double value, double dead_zone) {
    const double size = std::abs(value);
    return size < dead_zone ? 0 : std::copysign((size - dead_zone) / (1 - dead_zone), value);
}

std::vector<Trigger> pressed_at(const PadState& pad) {
    std::vector<Trigger> pressed;
    for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
        if (pad.buttons[i]) {
            pressed.push_back({Trigger::Device::pad, static_cast<int>(i)});
        }
    }
    if (pad.left_trigger > 0) {
        pressed.push_back({Trigger::Device::pad, kLeftTrigger});
    }
    if (pad.right_trigger > 0) {
        pressed.push_back({Trigger::Device::pad, kRightTrigger});
    }
    return pressed;
}

bool contains(const std::vector<Trigger>& triggers, Trigger trigger) {
    return std::ranges::find(triggers, trigger) != triggers.end();
}

}  // namespace

std::int16_t turn_units(double radians) {
    return static_cast<std::int16_t>(std::clamp(std::lround(radians / kTurnUnit), -32767L, 32767L));
}

Controls::Controls(std::span<const Action> actions) : bindings_(actions), states_(actions.size()) {}

void Controls::set_bindings(Bindings bindings) {
    bindings_ = std::move(bindings);
    states_.assign(bindings_.actions().size(), {});
    down_.clear();
}

void Controls::set_look(double mouse, bool inverted) {
    mouse_ = mouse;
    up_ = inverted ? -1 : 1;
}

void Controls::set_sticks(double speed, double dead_zone) {
    stick_ = speed;
    dead_zone_ = dead_zone;
}

bool Controls::is_down(std::size_t row) const {
    return std::ranges::any_of(down_, [&](Trigger t) { return bindings_.binds(t, row); });
}

void Controls::press(Trigger trigger, double now) {
    if (contains(down_, trigger)) {
        return;
    }
    for (std::size_t row = 0; row < states_.size(); ++row) {
        if (bindings_.binds(trigger, row) && !is_down(row)) {
            states_[row].waiting = std::min(states_[row].waiting + 1, kMostWaiting);
        }
    }
    down_.push_back(trigger);
    events_next_.push_back({trigger, true, now});
}

void Controls::release(Trigger trigger, double now) {
    if (std::erase(down_, trigger) == 0) {
        return;
    }
    events_next_.push_back({trigger, false, now});
    for (std::size_t row = 0; row < states_.size(); ++row) {
        if (!is_down(row)) {
            states_[row].ignored = false;
        }
    }
}

void Controls::turn_mouse(double right, double down) {
    yaw_ -= right * mouse_ * kMouseRadians;
    pitch_ -= down * mouse_ * up_ * kMouseRadians;
}

void Controls::set_pad(const std::optional<PadState>& pad, double seconds, double now) {
    const std::vector<Trigger> before = pad_ ? pressed_at(*pad_) : std::vector<Trigger>();
    const std::vector<Trigger> after = pad ? pressed_at(*pad) : std::vector<Trigger>();
    for (const Trigger trigger : before) {
        if (!contains(after, trigger)) {
            release(trigger, now);
        }
    }
    for (const Trigger trigger : after) {
        if (!contains(before, trigger)) {
            press(trigger, now);
        }
    }
    pad_ = pad;
    if (pad) {
        yaw_ -= tilt(pad->right_x, dead_zone_) * stick_ * kStickRadians * seconds;
        pitch_ -= tilt(pad->right_y, dead_zone_) * up_ * stick_ * kStickRadians * seconds;
    }
}

void Controls::begin_frame(bool playing) {
    events_ = std::exchange(events_next_, {});
    const bool goes_on = playing && !playing_;
    for (std::size_t row = 0; row < states_.size(); ++row) {
        State& state = states_[row];
        const Kind kind = bindings_.actions()[row].kind;
        if (!reaches_steps(kind)) {
            asked_[row] = std::exchange(state.waiting, 0) > 0;
        }
        if (!playing) {
            state = {};
        } else if (goes_on && kind == Kind::pressed) {
            state.ignored = is_down(row) && state.waiting == 0;
        }
    }
    if (!playing) {
        yaw_ = pitch_ = 0;
    }
    playing_ = playing;
}

std::vector<Trigger> Controls::pressed() const {
    std::vector<Trigger> pressed;
    for (const Event& event : events_) {
        if (event.down) {
            pressed.push_back(event.trigger);
        }
    }
    return pressed;
}

bool Controls::next(std::size_t row) {
    State& now = states_[row];
    if (now.waiting > 0 && !now.last) {
        --now.waiting;
        now.last = true;
    } else {
        now.last = now.waiting == 0 && is_down(row) && !now.ignored;
    }
    return now.last;
}

Step Controls::take() {
    Step step;
    if (!playing_) {
        return step;
    }
    if (pad_) {
        step.right = tilt(pad_->left_x, dead_zone_);
        step.forward = -tilt(pad_->left_y, dead_zone_);
    }
    step.yaw = turn_units(yaw_);
    step.pitch = turn_units(pitch_);
    // What rounding left over waits for the next step.
    yaw_ -= step.yaw * kTurnUnit;
    pitch_ -= step.pitch * kTurnUnit;
    for (std::size_t row = 0; row < states_.size(); ++row) {
        const Action& action = bindings_.actions()[row];
        const bool was_down = states_[row].last;
        if (reaches_steps(action.kind) && next(row)) {
            step.down.set(row);
            step.begun.set(row, !was_down);
            step.marks |= action.mark;
        }
    }
    return step;
}

}  // namespace lanthorn::input
