#include "engine/assets/gltf_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace lanthorn {

namespace {

bool is_usable(float value) {
    return std::abs(value) <= kLargestKeyValue;  // false for NaN
}

double length_of(std::span<const float> q) {
    return std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0, std::plus<>(),
                                        [](double a, double b) { return a * b; }));
}

class KeyRepair {
  public:
    explicit KeyRepair(AnimationChannel& channel)
        : channel_(channel),
          cubic_(channel.interpolation == Interpolation::cubic_spline),
          width_(channel.width),
          floats_(channel.width * (cubic_ ? 3 : 1)) {}

    KeyFaults run() {
        clear_unused_tangents();
        std::vector<std::size_t> keys = usable_keys();
        sort(keys);
        keys = without_hidden(keys);
        take(keys);
        return faults_;
    }

  private:
    std::span<float> key(std::size_t k) { return std::span(channel_.values).subspan(k * floats_, floats_); }
    std::span<float> value(std::size_t k) { return key(k).subspan(cubic_ ? width_ : 0, width_); }

    // glTF 2.0, appendix C.5: the first in-tangent and the last out-tangent say nothing.
    void clear_unused_tangents() {
        if (cubic_ && !channel_.times.empty()) {
            for (float& unused : key(0).first(width_)) {
                unused = is_usable(unused) ? unused : 0.0f;
            }
            for (float& unused : key(channel_.times.size() - 1).last(width_)) {
                unused = is_usable(unused) ? unused : 0.0f;
            }
        }
    }

    std::vector<std::size_t> usable_keys() {
        std::vector<std::size_t> keys;
        for (std::size_t k = 0; k < channel_.times.size(); ++k) {
            if (!(std::abs(channel_.times[k]) <= kLargestKeyTime)) {
                ++faults_.bad_times;
            } else if (!std::ranges::all_of(key(k), is_usable) || !is_rotation_usable(k)) {
                ++faults_.bad_values;
            } else {
                keys.push_back(k);
            }
        }
        return keys;
    }

    // Normalised where it is no unit quaternion by more than the rounding of quantised ones.
    bool is_rotation_usable(std::size_t k) {
        if (channel_.path != AnimationPath::rotation) {
            return true;
        }
        const double length = length_of(value(k));
        if (!(length > 1e-12)) {
            return false;
        }
        if (std::abs(length - 1) > 1e-2) {
            ++faults_.long_rotations;
            for (float& component : value(k)) {
                component = static_cast<float>(component / length);
            }
        }
        return true;
    }

    void sort(std::vector<std::size_t>& keys) {
        float latest = -std::numeric_limits<float>::infinity();
        for (const std::size_t k : keys) {
            faults_.unordered += channel_.times[k] < latest;
            latest = std::max(latest, channel_.times[k]);
            faults_.early += channel_.times[k] < 0;
        }
        std::ranges::stable_sort(keys, {}, [&](std::size_t k) { return channel_.times[k]; });
    }

    // Of keys of one time, those between the first and the last are never seen; of those at 0, where clips
    // begin, all but the last.
    std::vector<std::size_t> without_hidden(const std::vector<std::size_t>& keys) {
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto same = [&](std::size_t j) {
                return j < keys.size() && channel_.times[keys[j]] == channel_.times[keys[i]];
            };
            const bool after = i > 0 && same(i - 1), before = same(i + 1);
            faults_.repeated += after;
            const bool at_start = channel_.times[keys[i]] == 0 && kept.empty();
            if (!before || (!after && !at_start)) {
                kept.push_back(keys[i]);
            }
        }
        return kept;
    }

    void take(const std::vector<std::size_t>& keys) {
        std::vector<float> times, values;
        times.reserve(keys.size());
        values.reserve(keys.size() * floats_);
        for (const std::size_t k : keys) {
            const float earliest = times.empty()
                                       ? -kLargestKeyTime
                                       : std::nextafter(times.back(), std::numeric_limits<float>::infinity());
            times.push_back(std::max(channel_.times[k], earliest));
            values.insert(values.end(), key(k).begin(), key(k).end());
        }
        channel_.times = std::move(times);
        channel_.values = std::move(values);
    }

    AnimationChannel& channel_;
    bool cubic_;
    std::size_t width_, floats_;
    KeyFaults faults_;
};

// "3 keys" "1 key"
void tell(std::vector<std::string>& lines, std::size_t count, const char* what, const char* done) {
    if (count > 0) {
        lines.push_back(fmt::format("{} key{} {}; {}", count, count == 1 ? "" : "s", what, done));
    }
}

}  // namespace

std::vector<std::string> KeyFaults::about_times() const {
    std::vector<std::string> lines;
    tell(lines, bad_times, "at a time that is no number or beyond 1e9 s", "left out");
    tell(lines, unordered, "earlier than one before", "sorted by time");
    tell(lines, repeated, "at the time of one before", "the values leap there");
    tell(lines, early, "before 0 s", "kept, and played from 0 on");
    return lines;
}

std::vector<std::string> KeyFaults::about_values() const {
    std::vector<std::string> lines;
    tell(lines, bad_values, "no number, beyond 1e18, or a rotation of zero", "left out");
    if (long_rotations > 0) {
        lines.push_back(fmt::format("{} rotations are not of length 1; normalised", long_rotations));
    }
    return lines;
}

KeyFaults repair_keys(AnimationChannel& channel) {
    return KeyRepair(channel).run();
}

}  // namespace lanthorn
