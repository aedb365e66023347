#include "game/presentation/controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanthorn::game {

namespace {

constexpr double kMouseRadians = 0.0022;  // a pixel
constexpr double kStickRadians = 2.6;     // a second, at full tilt
constexpr double kDeadZone = 0.18;
// Presses that wait for a step. The wheel can send more than the steps of a frame take: what goes on long
// after the hand has stopped helps nobody.
constexpr int kMostWaiting = 4;

// What the steps see held down.
constexpr std::pair<Action, Button> kButtons[] = {
    {Action::use, kUse},      {Action::light, kLight},      {Action::carry, kCarry},
    {Action::dim_up, kDimUp}, {Action::dim_down, kDimDown}, {Action::colour, kColour},
    {Action::view, kView},    {Action::hint, kHint},        {Action::reset, kReset},
};

// A stick's axis without the slack around its middle.
double tilt(double value) {
    const double size = std::abs(value);
    return size < kDeadZone ? 0 : std::copysign((size - kDeadZone) / (1 - kDeadZone), value);
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

void Controls::set_bindings(Bindings bindings) {
    bindings_ = std::move(bindings);
    states_ = {};
    down_.clear();
}

void Controls::set_look(double mouse, bool inverted) {
    mouse_ = mouse;
    up_ = inverted ? -1 : 1;
}

bool Controls::down(Action action) const {
    return std::ranges::any_of(down_, [&](Trigger t) { return bindings_.binds(t, action); });
}

void Controls::press(Trigger trigger) {
    if (contains(down_, trigger)) {
        return;
    }
    for (const ActionInfo& info : actions()) {
        if (bindings_.binds(trigger, info.action) && !down(info.action)) {
            State& now = state(info.action);
            now.waiting = std::min(now.waiting + 1, kMostWaiting);
        }
    }
    down_.push_back(trigger);
    pressed_next_.push_back(trigger);
}

void Controls::release(Trigger trigger) {
    std::erase(down_, trigger);
    for (const ActionInfo& info : actions()) {
        if (!down(info.action)) {
            state(info.action).ignored = false;
        }
    }
}

void Controls::turn_mouse(double right, double down) {
    yaw_ -= right * mouse_ * kMouseRadians;
    pitch_ -= down * mouse_ * up_ * kMouseRadians;
}

void Controls::set_pad(const std::optional<PadState>& pad, double seconds) {
    const std::vector<Trigger> before = pad_ ? pressed_at(*pad_) : std::vector<Trigger>();
    const std::vector<Trigger> now = pad ? pressed_at(*pad) : std::vector<Trigger>();
    for (const Trigger trigger : before) {
        if (!contains(now, trigger)) {
            release(trigger);
        }
    }
    for (const Trigger trigger : now) {
        if (!contains(before, trigger)) {
            press(trigger);
        }
    }
    pad_ = pad;
    if (pad) {
        yaw_ -= tilt(pad->right_x) * kStickRadians * seconds;
        pitch_ -= tilt(pad->right_y) * up_ * kStickRadians * seconds;
    }
}

void Controls::begin_frame(bool playing) {
    menu_pressed_ = std::exchange(state(Action::menu).waiting, 0) > 0;
    pressed_ = std::exchange(pressed_next_, {});
    if (!playing) {
        yaw_ = pitch_ = 0;
        for (State& each : states_) {
            each = {};
        }
    } else if (!playing_) {
        for (const auto& [action, button] : kButtons) {
            state(action).ignored = down(action) && state(action).waiting == 0;
        }
    }
    playing_ = playing;
}

bool Controls::next(Action action) {
    State& now = state(action);
    if (now.waiting > 0 && !now.last) {
        --now.waiting;
        now.last = true;
    } else {
        now.last = now.waiting == 0 && down(action) && !now.ignored;
    }
    return now.last;
}

PlayerInput Controls::take() {
    PlayerInput input;
    if (!playing_) {
        return input;
    }
    double forward = next(Action::forward) - next(Action::back) + 0.0;
    double right = next(Action::right) - next(Action::left) + 0.0;
    if (pad_) {
        right += tilt(pad_->left_x);
        forward -= tilt(pad_->left_y);
    }
    input.forward = axis(forward);
    input.right = axis(right);
    input.yaw = look(yaw_);
    input.pitch = look(pitch_);
    // What rounding left over waits for the next step.
    yaw_ -= input.yaw * kLookUnit;
    pitch_ -= input.pitch * kLookUnit;
    for (const auto& [action, button] : kButtons) {
        if (next(action)) {
            input.held = static_cast<std::uint16_t>(input.held | button);
        }
    }
    return input;
}

}  // namespace lanthorn::game
