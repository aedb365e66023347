#include "engine/runtime/triangle_ray.h"

#include <cmath>
#include <utility>

namespace lanthorn {

TriangleRay::TriangleRay(const dvec3& direction) {
    const dvec3 size = glm::abs(direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (direction[z_] < 0) {  // triangles keep their winding
        std::swap(x_, y_);
    }
    shear_ = {direction[x_] / direction[z_], direction[y_] / direction[z_], 1 / direction[z_]};
}

std::optional<TriangleRay::Hit> TriangleRay::meet(const dvec3& a, const dvec3& b, const dvec3& c) const {
    const dvec3 pa = sheared(a), pb = sheared(b), pc = sheared(c);
    const double u = pc.x * pb.y - pc.y * pb.x;
    const double v = pa.x * pc.y - pa.y * pc.x;
    const double w = pb.x * pa.y - pb.y * pa.x;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) {
        return std::nullopt;
    }
    const double sum = u + v + w;
    if (!(std::abs(sum) > 0)) {
        return std::nullopt;
    }
    const dvec3 barycentric = dvec3(u, v, w) / sum;
    return Hit{glm::dot(barycentric, dvec3(pa.z, pb.z, pc.z)), barycentric, sum > 0};
}

}  // namespace lanthorn
