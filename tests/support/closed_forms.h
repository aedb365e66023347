// Light that is known on paper: what implementations are held against.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "lanthorn/core/math.h"

namespace lanthorn::support {

inline constexpr double kPiD = 3.14159265358979323846;

// Inside a closed sphere of `radius` with `candela` at its centre: irradiance after 1 to `bounces`
// reflections, in lux (Jacquez and Kuppenheim 1955, integrating sphere theory).
inline double sphere_irradiance(double candela, double radius, double albedo, int bounces) {
    double sum = 0;
    for (int b = 1; b <= bounces; ++b) {
        sum += std::pow(albedo, b) * candela / (radius * radius);
    }
    return sum;
}

// Configuration factor from an element to a parallel rectangle a x b at distance h whose corner is on the
// element's normal (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3).
inline double parallel_corner(double a, double b, double h) {
    const double x = a / h, y = b / h, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * kPiD);
}

// To a rectangle square to the element's plane that stands on it, height a, width b, at distance c with one
// lower corner opposite (Howell, B-4).
inline double perpendicular_corner(double a, double b, double c) {
    const double x = a / b, y = c / b, s = std::sqrt(x * x + y * y);
    return (std::atan(1 / y) - y / s * std::atan(1 / s)) / (2 * kPiD);
}

// Between equal, opposite plates a x b at distance c (Howell, C-11).
inline double parallel_plates(double a, double b, double c) {
    const double x = a / c, y = b / c, x2 = 1 + x * x, y2 = 1 + y * y;
    return 2 / (kPiD * x * y) *
           (0.5 * std::log(x2 * y2 / (1 + x * x + y * y)) + x * std::sqrt(y2) * std::atan(x / std::sqrt(y2)) +
            y * std::sqrt(x2) * std::atan(y / std::sqrt(x2)) - x * std::atan(x) - y * std::atan(y));
}

// From the plate of width w to the one of height h, at right angles with a common edge of length l (Howell,
// C-14).
inline double perpendicular_plates(double h, double w, double l) {
    const double H = h / l, W = w / l, h2 = H * H, w2 = W * W, s = h2 + w2;
    const double logs = std::log((1 + w2) * (1 + h2) / (1 + s)) +
                        w2 * std::log(w2 * (1 + s) / ((1 + w2) * s)) +
                        h2 * std::log(h2 * (1 + s) / ((1 + h2) * s));
    return (W * std::atan(1 / W) + H * std::atan(1 / H) - std::sqrt(s) * std::atan(1 / std::sqrt(s)) +
            0.25 * logs) /
           (kPiD * W);
}

// From an element at `p` facing `normal` to a quadrilateral all of whose front it sees above its horizon:
// Lambert's sum over the edges (Lambert 1760; Baum, Rushmeier and Winget 1989, eq. 5).
inline double polygon_factor(const std::array<dvec3, 4>& corners, const dvec3& p, const dvec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 a = glm::normalize(corners[i] - p);
        const dvec3 b = glm::normalize(corners[(i + 1) % 4] - p);
        const dvec3 axis = glm::cross(a, b);
        const double sine = glm::length(axis);
        if (sine > 0) {
            sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(axis / sine, normal);
        }
    }
    return std::abs(sum) / (2 * kPiD);
}

// KHR_lights_punctual: the square of a linear ramp in the cosine, from the outer cone to the inner one.
inline double spot_cone(double cosine, double inner, double outer) {
    const double ramp = (cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    return std::pow(std::clamp(ramp, 0.0, 1.0), 2);
}

// KHR_lights_punctual: how much of a light of `range` is left at `distance`, without the inverse square.
inline double range_window(double distance, double range) {
    return std::clamp(1 - std::pow(distance / range, 4), 0.0, 1.0);
}

}  // namespace lanthorn::support
