#include "tools/scene_generator/lathe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanthorn::scene_generator {

void add_quarter(Outline& outline, const glm::dvec2& centre, double radius, double from, int steps) {
    for (int i = 0; i <= steps; ++i) {
        const double angle = (from + 90.0 * i / steps) * std::numbers::pi / 180;
        const glm::dvec2 normal(std::cos(angle), std::sin(angle));
        outline.push_back({centre + radius * normal, normal});
    }
}

void add_curve(Outline& outline, const std::vector<glm::dvec2>& points, int steps) {
    const auto at = [&](std::ptrdiff_t i) {
        return points[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(points.size()) - 1))];
    };
    const auto spans = static_cast<std::ptrdiff_t>(points.size()) - 1;
    for (std::ptrdiff_t span = 0; span < spans; ++span) {
        const glm::dvec2 a = at(span), b = at(span + 1);
        const glm::dvec2 out = 0.5 * (b - at(span - 1)), in = 0.5 * (at(span + 2) - a);
        for (int i = span == 0 ? 0 : 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps, t2 = t * t, t3 = t2 * t;
            const glm::dvec2 p =
                (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * out + (-2 * t3 + 3 * t2) * b + (t3 - t2) * in;
            const glm::dvec2 way =
                (6 * t2 - 6 * t) * (a - b) + (3 * t2 - 4 * t + 1) * out + (3 * t2 - 2 * t) * in;
            outline.push_back({p, glm::normalize(glm::dvec2(way.y, -way.x))});
        }
    }
}

Shape lathe(const Outline& outline, int sides, bool loop) {
    Shape shape;
    const auto on_axis = [&](std::size_t k) { return outline[k].place.x == 0; };
    const auto corner = [&](std::size_t k, int side) {
        const double angle = 2 * std::numbers::pi * (side % sides) / sides;
        const dvec3 out(std::cos(angle), 0, std::sin(angle));
        const OutlinePoint& point = outline[k];
        shape.corners.push_back({out * point.place.x + dvec3(0, point.place.y, 0),
                                 glm::normalize(out * point.normal.x + dvec3(0, point.normal.y, 0)),
                                 {static_cast<double>(side) / sides,
                                  1 - static_cast<double>(k) / static_cast<double>(outline.size())}});
    };
    for (std::size_t k = 0; k < outline.size(); ++k) {
        for (int side = 0; side <= sides; ++side) {
            corner(k, side);
        }
    }
    const auto row = static_cast<std::uint32_t>(sides + 1);
    for (std::size_t k = 0; k + (loop ? 0 : 1) < outline.size(); ++k) {
        const std::size_t next = (k + 1) % outline.size();
        if (outline[k].place == outline[next].place) {
            continue;
        }
        for (std::uint32_t side = 0; side + 1 < row; ++side) {
            const auto a = static_cast<std::uint32_t>(k) * row + side;
            const auto b = static_cast<std::uint32_t>(next) * row + side;
            if (!on_axis(next)) {
                shape.indices.insert(shape.indices.end(), {a, b, b + 1});
            }
            if (!on_axis(k)) {
                shape.indices.insert(shape.indices.end(), {a, on_axis(next) ? b : b + 1, a + 1});
            }
        }
    }
    return shape;
}

Shape ring_band(double inner, double outer, double height, double edge, int sides) {
    constexpr int kSteps = 5;
    Outline outline;
    add_quarter(outline, {outer - edge, edge}, edge, -90, kSteps);
    add_quarter(outline, {outer - edge, height - edge}, edge, 0, kSteps);
    add_quarter(outline, {inner + edge, height - edge}, edge, 90, kSteps);
    add_quarter(outline, {inner + edge, edge}, edge, 180, kSteps);
    return lathe(outline, sides, true);
}

}  // namespace lanthorn::scene_generator
