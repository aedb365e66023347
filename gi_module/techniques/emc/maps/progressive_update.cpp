#include "gi_module/techniques/emc/maps/progressive_update.h"

#include <algorithm>

namespace lanthorn::gi {

int ProgressiveUpdate::shares(int interval) {
    constexpr int kMost = 10;
    return std::min(interval, kMost);
}

ProgressiveUpdate::Candidates ProgressiveUpdate::candidates(int share, int shares, int candidates, int k) {
    const int asked = std::min(k, candidates / 2) + 1;
    const int work = candidates + asked;
    const auto end = [&](int of) { return std::clamp((of + 1) * work / shares - asked, 0, candidates); };
    return {share == 0 ? 0 : end(share - 1), end(share)};
}

ProgressiveUpdate::Step ProgressiveUpdate::step(bool geometry_changes, int interval) const {
    Step step;
    step.shares = shares(interval);
    step.round = geometry_changes || pending_;
    if (step.round) {
        step.frames_left = std::max(interval - 1 - frame_, 0);
        step.share = step.frames_left < step.shares ? step.shares - 1 - step.frames_left : -1;
        step.last = step.frames_left == 0;
    }
    step.ask = looked_;
    step.exchange = asked_;
    return step;
}

void ProgressiveUpdate::advance(bool geometry_changed, const Step& step) {
    pending_ = pending_ || geometry_changed;
    // The first share is seen after geometry has moved.
    changed_since_look_ = step.share != 0 && (changed_since_look_ || geometry_changed);
    looked_ = step.last;
    asked_ = step.ask;
    if (step.last) {
        frame_ = 0;
        pending_ = changed_since_look_;
    } else if (pending_) {
        ++frame_;
    }
}

}  // namespace lanthorn::gi
