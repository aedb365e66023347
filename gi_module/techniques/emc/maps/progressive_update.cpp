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
    step.round = geometry_changes || !settled();
    if (step.round) {
        step.frames_left = std::max(interval - 1 - frame_, 0);
        step.share = step.frames_left < step.shares ? step.shares - 1 - step.frames_left : -1;
        step.last = step.frames_left == 0;
    }
    step.ask = looked_.has_value();
    step.exchange = asked_.has_value();
    return step;
}

void ProgressiveUpdate::advance(bool geometry_changed, bool exchanged, const Step& step) {
    if (geometry_changed) {
        ++changes_;
        exchanges_ = 0;
    }
    // In a frame the exchange comes before the look, which sees candidates of earlier shares again
    // (MapCentres::look): the round that looks sees it.
    if (exchanged) {
        looking_ += looking_ == changes_ ? 1 : 0;
        ++changes_;
        ++exchanges_;
    } else if (step.exchange && asked_ == changes_) {
        settled_ = changes_;
    }
    settled_ = exchanges_ < kMostExchanges ? settled_ : changes_;
    looking_ = step.share == 0 ? changes_ : looking_;
    asked_ = step.ask && !settled() ? looked_ : std::nullopt;
    looked_ = step.last && !settled() ? std::optional(looking_) : std::nullopt;
    frame_ = step.last || settled() ? 0 : frame_ + 1;
}

}  // namespace lanthorn::gi
