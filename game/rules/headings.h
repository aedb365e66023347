// Headings on the ground: radians, 0 along -Z, positive to the left.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lanthorn/core/math.h"
#include "lanthorn/core/turns.h"

namespace lanthorn::game {

// The last bits of the C library's angles differ by processor; a recording is compared bit for bit.
inline double rounded(double radians) {
    return std::round(radians * 1e9) / 1e9;
}

// Of a way that is not upright.
inline double heading_of(const dvec3& way) {
    return rounded(std::atan2(-way.x, -way.z));
}

// Unit, level.
inline dvec3 facing_of(double heading) {
    const SineCosine turn = sine_cosine(heading);
    return {-turn.sine, 0, -turn.cosine};
}

// The short way round from one to the other, -pi to pi.
inline double turn_between(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);
}

// `from` turned towards `to` by a `share` of what is between them, at most `most` radians.
inline double turned_towards(double from, double to, double share, double most) {
    return std::remainder(from + std::clamp(share * turn_between(from, to), -most, most),
                          2 * std::numbers::pi);
}

}  // namespace lanthorn::game
