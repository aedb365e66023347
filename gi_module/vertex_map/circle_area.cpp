#include "lanthorn/vertex_map/circle_area.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double sector(const glm::dvec2& a, const glm::dvec2& b, double radius2) {
    return 0.5 * radius2 * std::atan2(cross(a, b), glm::dot(a, b));
}

// Between the segment from a to b, the origin and the circle.
double edge_area(const glm::dvec2& a, const glm::dvec2& b, double radius2) {
    const glm::dvec2 d = b - a;
    const double length2 = glm::dot(d, d);
    if (!(length2 > 0)) {
        return 0;
    }
    // Where the line enters and leaves the circle, in lengths of the segment.
    const double middle = -glm::dot(a, d) / length2;
    const glm::dvec2 foot = a + d * middle;
    const double rest = radius2 - glm::dot(foot, foot);
    if (!(rest > 0)) {
        return sector(a, b, radius2);
    }
    const double half = std::sqrt(rest / length2);
    const double in = std::clamp(middle - half, 0.0, 1.0), out = std::clamp(middle + half, 0.0, 1.0);
    const glm::dvec2 p = a + d * in, q = a + d * out;
    double area = 0.5 * cross(p, q);
    area += in > 0 ? sector(a, p, radius2) : 0;
    area += out < 1 ? sector(q, b, radius2) : 0;
    return area;
}

}  // namespace

float circle_triangle_area(const vec2& a, const vec2& b, const vec2& c, float radius) {
    const glm::dvec2 p(a), q(b), r(c);
    const double radius2 = static_cast<double>(radius) * static_cast<double>(radius);
    return static_cast<float>(edge_area(p, q, radius2) + edge_area(q, r, radius2) + edge_area(r, p, radius2));
}

}  // namespace lanthorn::gi
