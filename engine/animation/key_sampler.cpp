#include "engine/animation/key_sampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanthorn {
namespace {

// The k with times[k] <= time < times[k + 1]. `time` must lie between the first key and the last.
std::uint32_t key_before(const std::vector<float>& times, double time, std::uint32_t hint) {
    const auto last = static_cast<std::uint32_t>(times.size() - 1);
    for (std::uint32_t k = hint; k < last && k <= hint + 1; ++k) {
        if (times[k] <= time && time < times[k + 1]) {
            return k;
        }
    }
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    return static_cast<std::uint32_t>(after - times.begin()) - 1;
}

double dot4(const float* a, const float* b) {
    return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2] + double{a[3]} * b[3];
}

void normalise(std::span<double> q) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 0)) {  // a spline through zero has no direction there
        q[0] = q[1] = q[2] = 0;
        q[3] = 1;
        return;
    }
    for (double& c : q) {
        c /= length;
    }
}

// Appendix C.4.
void slerp(const float* from, const float* to, double u, std::span<double> value) {
    constexpr double kNearlyEqual = 1e-6;  // sine below which the straight line differs by less than rounding
    const double along = dot4(from, to);
    const double sign = along < 0 ? -1.0 : 1.0;
    const double angle = std::acos(std::min(std::abs(along), 1.0));
    const double sine = std::sin(angle);
    double a = 1 - u;
    double b = u;
    if (sine > kNearlyEqual) {
        a = std::sin(angle * (1 - u)) / sine;
        b = std::sin(angle * u) / sine;
    }
    for (std::size_t c = 0; c < 4; ++c) {
        value[c] = a * from[c] + sign * b * to[c];
    }
}

// Appendix C.5: a key is in-tangent, value, out-tangent.
void spline(const AnimationChannel& channel, std::uint32_t key, double u, double seconds,
            std::span<double> value) {
    const std::size_t width = channel.width;
    const float* here = channel.values.data() + std::size_t{key} * 3 * width;
    const float* next = here + 3 * width;
    const double u2 = u * u;
    const double u3 = u2 * u;
    const double from_value = 2 * u3 - 3 * u2 + 1;
    const double from_tangent = seconds * (u3 - 2 * u2 + u);
    const double to_value = -2 * u3 + 3 * u2;
    const double to_tangent = seconds * (u3 - u2);
    for (std::size_t c = 0; c < width; ++c) {
        value[c] = from_value * here[width + c] + from_tangent * here[2 * width + c] +
                   to_value * next[width + c] + to_tangent * next[c];
    }
}

void take_key(const AnimationChannel& channel, std::uint32_t key, std::span<double> value) {
    const std::size_t width = channel.width;
    const std::size_t first = channel.interpolation == Interpolation::cubic_spline
                                  ? (std::size_t{key} * 3 + 1) * width
                                  : key * width;
    for (std::size_t c = 0; c < width; ++c) {
        value[c] = channel.values[first + c];
    }
}

}  // namespace

void sample(const AnimationChannel& channel, double time, std::uint32_t& hint, std::span<double> value) {
    assert(!channel.times.empty() && value.size() == channel.width);
    const auto last = static_cast<std::uint32_t>(channel.times.size() - 1);
    const bool rotation = channel.path == AnimationPath::rotation;
    if (!(time > channel.times.front()) || time >= channel.times.back()) {
        hint = time >= channel.times.back() ? last : 0;
        take_key(channel, hint, value);
        if (rotation) {
            normalise(value);
        }
        return;
    }
    const std::uint32_t key = key_before(channel.times, time, hint);
    hint = key;
    const double seconds = double{channel.times[key + 1]} - channel.times[key];
    const double u = (time - channel.times[key]) / seconds;
    const float* here = channel.values.data() + std::size_t{key} * channel.width;
    const float* next = here + channel.width;
    switch (channel.interpolation) {
        case Interpolation::step:
            take_key(channel, key, value);
            break;
        case Interpolation::linear:
            if (rotation) {
                slerp(here, next, u, value);
            } else {
                for (std::size_t c = 0; c < channel.width; ++c) {
                    value[c] = (1 - u) * here[c] + u * next[c];
                }
            }
            break;
        case Interpolation::cubic_spline:
            spline(channel, key, u, seconds, value);
            break;
    }
    if (rotation) {
        normalise(value);
    }
}

}  // namespace lanthorn
