#include "lanthorn/shell/frame_budget.h"

#include <algorithm>
#include <array>

#include "lanthorn/core/settings_schema.h"

namespace lanthorn::shell {

namespace {

constexpr std::array kScales = {1.0, 0.87, 0.75, 0.65, 0.56, 0.48, 0.42, 0.36};
constexpr std::size_t kScalesOfBest = 4;  // down to here a smaller picture is better than a lower preset

// Of a frame's time, relative to that of `low`, and the share of it that no smaller picture spares: maps,
// photons and shadows, as a lantern is carried about at 640x360. What a machine makes of it differs; it is
// only the first guess, for the next frames are measured too.
constexpr std::array kPresetCosts = {1.0, 2.0, 3.5, 8.0};
constexpr double kFixed = 0.5;

constexpr std::size_t kFrames = 31;     // that are looked at
constexpr std::size_t kFewest = 9;      // that can say something
constexpr std::size_t kFewestSlow = 3;  // the same where they take kSlow milliseconds together
constexpr double kSlow = 1500;
constexpr int kDisturbed = 4;   // frames after a change: buffers and histories are made anew
constexpr double kAim = 0.9;    // of the budget, when something is lowered
constexpr double kRoom = 0.85;  // of the budget, that is left unused before something is raised
constexpr double kSoonest = 2000, kLatest = 64'000;  // milliseconds
constexpr double kKept = 8000;  // milliseconds: what was raised and holds for so long was right

double cost_of(std::size_t preset, double scale) {
    return kPresetCosts[preset] * (kFixed + (1 - kFixed) * scale * scale);
}

}  // namespace

std::string usual_preset(bool software) {
    return software ? "low" : "medium";
}

double usual_frame_ms(bool software) {
    return software ? kFrameMsOnCpu : 0;
}

ivec2 usual_picture_size(bool software) {
    return software ? ivec2(640, 360) : ivec2(1280, 720);
}

void FrameBudget::set(double ms, const std::string& best) {
    if (ms == ms_ && best == rungs_.front().spending.preset) {
        return;
    }
    ms_ = ms;
    rungs_.clear();
    const auto found = std::ranges::find(kPresetNames, best);
    const auto top = static_cast<std::size_t>(found - kPresetNames.begin());
    rungs_.push_back({{best, 1}, found == kPresetNames.end() ? 1 : cost_of(top, 1)});
    for (std::size_t below = 0; found != kPresetNames.end() && below <= top; ++below) {
        const std::size_t preset = top - below;
        const std::size_t first = below == 0 ? 1 : 0;
        const std::size_t last = preset == 0 ? kScales.size() : kScalesOfBest;
        for (std::size_t i = first; i < last; ++i) {
            const double cost = cost_of(preset, kScales[i]);
            if (cost < rungs_.back().cost) {
                rungs_.push_back({{std::string(kPresetNames[preset]), kScales[i]}, cost});
            }
        }
    }
    rung_ = 0;
    wait_ = kSoonest;
    raised_ = false;
    disturb();
}

void FrameBudget::disturb() {
    frames_.clear();
    disturbed_ = kDisturbed;
}

// What `share` of the frames stay below.
double FrameBudget::busy(double share) const {
    std::vector<double> all;
    std::ranges::transform(frames_, std::back_inserter(all), &Frame::busy_ms);
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::ranges::nth_element(all, at);
    return *at;
}

void FrameBudget::frame(double ms, double busy_ms) {
    if (!(ms_ > 0)) {
        return;
    }
    since_ += ms;
    if (disturbed_ > 0) {
        --disturbed_;
        return;
    }
    frames_.push_back({ms, busy_ms});
    if (frames_.size() > kFrames) {
        frames_.pop_front();
    }
    double looked_at = 0;
    for (const Frame& each : frames_) {
        looked_at += each.ms;
    }
    const bool slow = frames_.size() >= kFewestSlow && looked_at > kSlow;
    if (frames_.size() < kFewest && !slow) {
        return;
    }
    const auto over = static_cast<std::size_t>(
        std::ranges::count_if(frames_, [&](const Frame& f) { return f.busy_ms > kTolerance * ms_; }));
    if (2 * over > frames_.size()) {
        lower();
    } else if (since_ > wait_ && frames_.size() == kFrames) {
        raise();
    }
}

void FrameBudget::lower() {
    if (rung_ + 1 == rungs_.size()) {
        return;
    }
    if (raised_) {
        wait_ = since_ < kKept ? std::min(2 * wait_, kLatest) : kSoonest;
    }
    const double now = busy(0.5) / rungs_[rung_].cost;
    std::size_t to = rung_ + 1;
    while (to + 1 < rungs_.size() && now * rungs_[to].cost > kAim * ms_) {
        ++to;
    }
    raised_ = false;
    go_to(to);
}

void FrameBudget::raise() {
    if (rung_ == 0 || busy(0.75) / rungs_[rung_].cost * rungs_[rung_ - 1].cost > kRoom * ms_) {
        return;
    }
    raised_ = true;
    go_to(rung_ - 1);
}

void FrameBudget::go_to(std::size_t rung) {
    rung_ = rung;
    since_ = 0;
    ++changes_;
    disturb();
}

}  // namespace lanthorn::shell
