#include "gi_module/shared/photons/circle_triangle.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Triangle 0, a, b, signed.
AreaMoment wedge(const glm::dvec2& a, const glm::dvec2& b) {
    const double area = 0.5 * cross(a, b);
    return {area, area / 6 * (glm::dot(a, a) + glm::dot(a, b) + glm::dot(b, b))};
}

// Sector from the direction of a to that of b, the short way round, signed.
AreaMoment sector(const glm::dvec2& a, const glm::dvec2& b, double radius) {
    const double angle = std::atan2(cross(a, b), glm::dot(a, b));
    const double area = 0.5 * angle * radius * radius;
    return {area, 0.5 * area * radius * radius};
}

AreaMoment edge(const glm::dvec2& a, const glm::dvec2& b, double radius) {
    const glm::dvec2 d = b - a;
    const double dd = glm::dot(d, d), r2 = radius * radius;
    const double along = -glm::dot(a, d);
    const double distance = cross(a, d);  // of the line from 0, times its length
    const double within = r2 * dd - distance * distance;
    if (!(dd > 0)) {
        return {};
    }
    if (!(within > 0)) {
        return sector(a, b, radius);
    }
    const double half = std::sqrt(within);
    const double in = std::clamp((along - half) / dd, 0.0, 1.0),
                 out = std::clamp((along + half) / dd, 0.0, 1.0);
    if (!(in < out)) {
        return sector(a, b, radius);
    }
    const glm::dvec2 p = a + d * in, q = a + d * out;
    AreaMoment sum = wedge(p, q);
    if (in > 0) {
        sum += sector(a, p, radius);
    }
    if (out < 1) {
        sum += sector(q, b, radius);
    }
    return sum;
}

}  // namespace

AreaMoment circle_triangle(const std::array<glm::dvec2, 3>& p, double radius) {
    AreaMoment sum;
    if (!(radius > 0)) {
        return sum;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        sum += edge(p[i], p[(i + 1) % 3], radius);
    }
    const double sign = sum.area < 0 ? -1 : 1;
    return {sign * sum.area, sign * sum.moment};
}

AreaMoment sphere_triangle(const std::array<dvec3, 3>& p, double radius) {
    const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(normal);
    if (!(length > 0)) {
        return {};
    }
    const dvec3 n = normal / length;
    const double height = glm::dot(n, p[0]);
    const double r2 = radius * radius - height * height;
    if (!(r2 > 0)) {
        return {};
    }
    const dvec3 u = glm::normalize(p[1] - p[0]), v = glm::cross(n, u);
    std::array<glm::dvec2, 3> flat;
    for (std::size_t i = 0; i < 3; ++i) {
        flat[i] = {glm::dot(p[i], u), glm::dot(p[i], v)};
    }
    AreaMoment result = circle_triangle(flat, std::sqrt(r2));
    result.moment += height * height * result.area;
    return result;
}

}  // namespace lanthorn::gi
