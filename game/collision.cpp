#include "game/collision.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::game {

namespace {

// Sideways offset from `box` to `point`, along the box's axes.
glm::dvec2 to_box(const Box& box, const dvec3& point) {
    const double c = std::cos(box.yaw), s = std::sin(box.yaw);
    const dvec3 d = point - box.centre;
    return {c * d.x - s * d.z, s * d.x + c * d.z};
}

dvec3 from_box(const Box& box, const glm::dvec2& v) {
    const double c = std::cos(box.yaw), s = std::sin(box.yaw);
    return {c * v.x + s * v.y, 0, -s * v.x + c * v.y};
}

bool beside(const Cylinder& body, const Box& box) {
    return body.foot.y < box.centre.y + box.half.y && body.foot.y + body.height > box.centre.y - box.half.y;
}

// The shortest way out of the box, in its axes; 0 if the circle does not overlap it.
glm::dvec2 way_out(const glm::dvec2& at, double radius, const glm::dvec2& half) {
    const glm::dvec2 nearest = glm::clamp(at, -half, half);
    const glm::dvec2 away = at - nearest;
    const double distance = glm::length(away);
    if (distance > 0) {
        return distance < radius ? away * ((radius - distance) / distance) : glm::dvec2(0);
    }
    // The centre is inside: out through the nearest side.
    const double x = half.x + radius - std::abs(at.x), z = half.y + radius - std::abs(at.y);
    return x < z ? glm::dvec2(at.x < 0 ? -x : x, 0) : glm::dvec2(0, at.y < 0 ? -z : z);
}

}  // namespace

Box turned_about(const Box& box, const dvec3& pivot, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const dvec3 d = box.centre;
    return {pivot + dvec3(c * d.x + s * d.z, d.y, -s * d.x + c * d.z), box.half, box.yaw + angle};
}

bool overlaps(const Cylinder& body, const Box& box) {
    return beside(body, box) &&
           way_out(to_box(box, body.foot), body.radius, {box.half.x, box.half.z}) != glm::dvec2(0);
}

bool overlaps(const Cylinder& body, std::span<const Box> boxes) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return overlaps(body, box); });
}

dvec3 pushed_out(Cylinder body, std::span<const Box> boxes) {
    for (int pass = 0; pass < 4; ++pass) {
        bool moved = false;
        for (const Box& box : boxes) {
            if (!beside(body, box)) {
                continue;
            }
            const glm::dvec2 out = way_out(to_box(box, body.foot), body.radius, {box.half.x, box.half.z});
            if (out != glm::dvec2(0)) {
                body.foot += from_box(box, out);
                moved = true;
            }
        }
        if (!moved) {
            break;
        }
    }
    return body.foot;
}

dvec3 slide(const Cylinder& body, const dvec3& way, std::span<const Box> boxes) {
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / (0.5 * body.radius))));
    Cylinder moving = body;
    for (int i = 0; i < steps; ++i) {
        moving.foot += way / double(steps);
        moving.foot = pushed_out(moving, boxes);
    }
    return moving.foot;
}

}  // namespace lanthorn::game
