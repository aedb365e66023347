// The sRGB transfer functions (IEC 61966-2-1), one channel at a time, and luminance.
#pragma once

#include <cmath>
#include <concepts>

#include "lanthorn/core/math.h"

namespace lanthorn {

// From a display-encoded value to a linear one, 0..1 both.
template <std::floating_point T>
T linear_from_srgb(T v) {
    return v <= T(0.04045) ? v / T(12.92) : std::pow((v + T(0.055)) / T(1.055), T(2.4));
}

// From a linear value to a display-encoded one, 0..1 both.
template <std::floating_point T>
T srgb_from_linear(T v) {
    return v <= T(0.0031308) ? T(12.92) * v : T(1.055) * std::pow(v, 1 / T(2.4)) - T(0.055);
}

// Of linear Rec. 709 primaries.
template <std::floating_point T>
T luminance(const glm::vec<3, T>& linear) {
    return glm::dot(linear, glm::vec<3, T>(T(0.2126), T(0.7152), T(0.0722)));
}

}  // namespace lanthorn
