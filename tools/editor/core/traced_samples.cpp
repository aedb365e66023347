#include "tools/editor/core/traced_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/core/progress.h"

namespace lanthorn::editor {

void TracedSamples::drew(const gi::SampleProgress& now, double ms) {
    const int before = now_.wanted > 0 && now.done > now_.done ? now_.done : 0;
    if (before == 0 && now.done != now_.done) {
        ms_.clear();
    }
    const int added = now.done - before;
    if (now.wanted > 0 && added > 0 && now != now_ && std::isfinite(ms) && ms > 0) {
        ms_.push_back(ms / added);
        if (ms_.size() > kPasses) {
            ms_.pop_front();
        }
    }
    now_ = now;
}

double TracedSamples::share() const {
    return grows() ? std::clamp(static_cast<double>(now_.done) / now_.wanted, 0.0, 1.0) : 0;
}

std::optional<double> TracedSamples::seconds_left() const {
    if (!due() || ms_.empty()) {
        return std::nullopt;
    }
    std::vector<double> sorted(ms_.begin(), ms_.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    return seconds_left(*middle);
}

double TracedSamples::seconds_left(double sample_ms) const {
    return due() ? 1e-3 * sample_ms * (now_.wanted - now_.done) : 0;
}

std::string TracedSamples::words() const {
    return grows() ? fmt::format("{} of {} samples", now_.done, now_.wanted) : std::string();
}

std::string TracedSamples::left_words() const {
    const std::optional<double> left = seconds_left();
    return left ? duration_words(*left) + " left" : std::string();
}

}  // namespace lanthorn::editor
