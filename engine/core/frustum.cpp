#include "lanthorn/core/frustum.h"

#include <cassert>

namespace lanthorn {

Frustum Frustum::of_clip(const mat4& clip_from_relative, const vec3& origin) {
    const mat4 rows = glm::transpose(clip_from_relative);
    Frustum frustum(origin);
    for (const vec4& plane : {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
                              rows[2], rows[3] - rows[2]}) {
        frustum.cut(vec3(plane), plane.w);
    }
    return frustum;
}

Frustum Frustum::of_cube_face(const vec3& centre, int face) {
    vec3 forward(0);
    forward[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
    Frustum frustum(centre);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == face / 2) {
            continue;
        }
        vec3 aside(0);
        aside[axis] = 1;
        frustum.cut(forward + aside);
        frustum.cut(forward - aside);
    }
    return frustum;
}

void Frustum::cut(const vec3& normal, float offset) {
    assert(count_ < kMostPlanes);
    planes_[static_cast<std::size_t>(count_++)] = vec4(normal, offset);
}

bool Frustum::touches(const Aabb& box) const {
    const dvec3 lower = dvec3(box.lower) - dvec3(origin_);
    const dvec3 upper = dvec3(box.upper) - dvec3(origin_);
    for (int axis = 0; axis < 3; ++axis) {
        if (lower[axis] > upper[axis]) {
            return false;
        }
    }
    const dvec3 largest = glm::max(glm::abs(lower), glm::abs(upper)) + dvec3(glm::abs(origin_));
    for (int i = 0; i < count_; ++i) {
        const vec4& plane = planes_[static_cast<std::size_t>(i)];
        double inside = plane.w, scale = std::abs(inside);  // at the corner farthest along the normal
        for (int axis = 0; axis < 3; ++axis) {
            const double n = plane[axis];
            inside += n * (n > 0 ? upper : lower)[axis];
            scale += std::abs(n) * largest[axis];
        }
        // Not the other way round: what is not a number is not outside.
        if (inside < -1e-5 * scale) {
            return false;
        }
    }
    return true;
}

}  // namespace lanthorn
