#include "lanthorn/gi/emc/progressive_update.h"

#include <algorithm>

namespace lanthorn::gi {

int ProgressiveUpdate::shares(int interval) {
    constexpr int kMost = 10;
    return std::min(interval, kMost);
}

ProgressiveUpdate::Candidates ProgressiveUpdate::candidates(int share, int shares, int candidates, int k) {
    const int work = candidates + std::min(k, candidates / 2) + 1;
    const int first = std::min(candidates, share * work / shares);
    return {first, share + 1 == shares ? candidates : std::min(candidates, (share + 1) * work / shares)};
}

ProgressiveUpdate::Step ProgressiveUpdate::step(bool geometry_changes, int interval) const {
    Step step;
    step.shares = shares(interval);
    step.round = geometry_changes || pending_;
    if (step.round) {
        step.frames_left = std::max(interval - 1 - frame_, 0);
        step.share = step.frames_left < step.shares ? step.shares - 1 - step.frames_left : -1;
        step.exchange = step.frames_left == 0;
    }
    return step;
}

void ProgressiveUpdate::advance(bool geometry_changed, const Step& step) {
    pending_ = pending_ || geometry_changed;
    // The first share is seen after geometry has moved.
    changed_since_look_ = step.share != 0 && (changed_since_look_ || geometry_changed);
    if (step.exchange) {
        frame_ = 0;
        pending_ = changed_since_look_;
    } else if (pending_) {
        ++frame_;
    }
}

}  // namespace lanthorn::gi
