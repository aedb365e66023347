#include "lanthorn/core/math.h"

namespace lanthorn {

Aabb transformed(const Aabb& box, const mat4& m) {
    if (box.empty()) {
        return {};
    }
    Aabb result{vec3(m[3]), vec3(m[3])};
    for (int axis = 0; axis < 3; ++axis) {
        const vec3 a = vec3(m[axis]) * box.lower[axis];
        const vec3 b = vec3(m[axis]) * box.upper[axis];
        result.lower += glm::min(a, b);
        result.upper += glm::max(a, b);
    }
    return result;
}

}  // namespace lanthorn
