#include "tools/editor/window/pace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanthorn::edit_window {

namespace {

constexpr std::array kScales = {1.0, 0.87, 0.75, 0.65, 0.56, 0.48, 0.42, 0.36, 0.3, 0.25};
// Of a frame's time, what no smaller picture spares: maps, photons, shadows. A first guess.
constexpr double kFixed = 0.35;
// Times the milliseconds of a frame at rest, which keeps what holds: a guess, before any under a hand.
constexpr double kLightMoves = 1.5;
constexpr double kNewest = 0.25;    // share of the newest frame in what is known of a hand's
constexpr std::size_t kEnough = 3;  // frames that tell that a scale is wrong
constexpr double kWrong = 1.4;      // times the budget

double share(double scale) {
    return kFixed + (1 - kFixed) * scale * scale;
}

}  // namespace

std::string_view name_of(Quality quality) {
    switch (quality) {
        case Quality::drag:
            return "drag";
        case Quality::rest:
            return "rest";
        case Quality::still:
            return "still";
    }
    return "";
}

void Pace::changed(double now, bool by_hand) {
    if (by_hand || held_) {
        if (now - changed_at_ >= kRestAfter) {
            choose_scale();  // a gesture begins
        }
        changed_at_ = now;
    }
    still_ = false;
    rested_ = 0;
    in_hand_ = 0;
}

void Pace::hold(bool held, double now) {
    if (held == held_) {
        return;
    }
    held_ = held;
    if (held) {
        choose_scale();
    } else {
        changed_at_ = std::max(changed_at_, now - kRestAfter / 2);
    }
}

void Pace::forget() {
    whole_ms_ = hand_ms_ = 0;
    drag_scale_ = 1;
    changed(changed_at_, false);
}

void Pace::choose_scale() {
    gesture_.clear();
    changes_ = 0;
    const double whole = hand_ms_ > 0 ? hand_ms_ : kLightMoves * whole_ms_;
    if (whole > 0) {
        const auto fits =
            std::ranges::find_if(kScales, [&](double scale) { return whole * share(scale) <= kDragMs; });
        drag_scale_ = fits == kScales.end() ? kScales.back() : *fits;
    }
}

Quality Pace::quality(double now) const {
    if (still_) {
        return Quality::still;
    }
    return held_ || now - changed_at_ < kRestAfter ? Quality::drag : Quality::rest;
}

void Pace::drew(Quality quality, double scale, double ms, double changed) {
    // The first frame of a size makes its buffers.
    const bool first = scale != drawn_scale_;
    drawn_scale_ = scale;
    if (!first && ms > 0) {
        const double whole = ms / share(scale);
        if (quality != Quality::drag) {
            whole_ms_ = whole;
        } else {
            hand_ms_ = hand_ms_ > 0 ? hand_ms_ + kNewest * (whole - hand_ms_) : whole;
        }
    }
    if (quality != Quality::drag) {
        ++rested_;
        still_ = (rested_ >= kFewest && changed <= kStill) || rested_ >= kMost;
        return;
    }
    ++in_hand_;
    if (first || changes_ > 0) {
        return;
    }
    gesture_.push_back(ms);
    const auto slow = static_cast<std::size_t>(
        std::ranges::count_if(gesture_, [](double each) { return each > kWrong * kDragMs; }));
    if (slow >= kEnough && 2 * slow > gesture_.size()) {
        choose_scale();
        changes_ = 1;
    }
}

}  // namespace lanthorn::edit_window
