#include "lanthorn/render/lines.h"

#include <cmath>

namespace lanthorn::render {

void Lines::add_box(const dmat4& to_world, const dvec3& lower, const dvec3& upper, const LineStyle& style) {
    const auto corner = [&](int bits) {
        const dvec3 at((bits & 1) != 0 ? upper.x : lower.x, (bits & 2) != 0 ? upper.y : lower.y,
                       (bits & 4) != 0 ? upper.z : lower.z);
        return dvec3(to_world * dvec4(at, 1));
    };
    for (int bits = 0; bits < 8; ++bits) {
        for (const int axis : {1, 2, 4}) {
            if ((bits & axis) == 0) {
                add(corner(bits), corner(bits | axis), style);
            }
        }
    }
}

void Lines::add_circle(const dvec3& centre, const dvec3& axis, double radius, const LineStyle& style,
                       int lines_around) {
    const dvec3 helper = std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const dvec3 right = glm::normalize(glm::cross(axis, helper)), up = glm::cross(right, axis);
    const auto at = [&](int i) {
        const double angle = 2 * static_cast<double>(kPi) * i / lines_around;
        return centre + radius * (std::cos(angle) * right + std::sin(angle) * up);
    };
    for (int i = 0; i < lines_around; ++i) {
        add(at(i), at(i + 1 < lines_around ? i + 1 : 0), style);
    }
}

void Lines::add_sphere(const dvec3& centre, double radius, const LineStyle& style, int lines_around) {
    for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
        add_circle(centre, axis, radius, style, lines_around);
    }
}

}  // namespace lanthorn::render
