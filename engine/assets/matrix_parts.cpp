#include "engine/assets/matrix_parts.h"

#include <algorithm>

namespace lanthorn {

namespace {

using glm::dmat3;

constexpr double kRounding = 1e-6;  // relative; glTF matrices usually are products of 32-bit numbers

// A unit vector perpendicular to the first `count` columns of `q`.
dvec3 completing(const dmat3& q, int count) {
    if (count == 2) {
        return glm::cross(q[0], q[1]);
    }
    const dvec3 axis = count == 0 || std::abs(q[0].x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    return count == 0 ? axis : glm::normalize(axis - q[0] * glm::dot(q[0], axis));
}

}  // namespace

void decompose(const dmat4& matrix, Transform& transform, mat3& shear) {
    const dmat3 a(matrix);
    const double size = std::max({glm::length(a[0]), glm::length(a[1]), glm::length(a[2])});
    dmat3 q(1);
    bool singular = false;
    for (int i = 0; i < 3; ++i) {  // Gram-Schmidt
        dvec3 rest = a[i];
        for (int k = 0; k < i; ++k) {
            rest -= q[k] * glm::dot(q[k], rest);
        }
        const double length = glm::length(rest);
        const bool vanishes = !(length > 1e-9 * glm::length(a[i])) || !(length > 1e-30 * size);
        singular = singular || vanishes;
        q[i] = vanishes ? completing(q, i) : rest / length;
    }
    if (glm::determinant(q) < 0) {
        q[0] = -q[0];
    }
    const dmat3 upper = glm::transpose(q) * a;  // column-major: upper[c][r], zero for r > c
    transform.translation = dvec3(matrix[3]);
    transform.rotation = quat(glm::normalize(glm::quat_cast(q)));
    dvec3 scale(1);
    if (!singular) {
        scale = {upper[0][0], upper[1][1], upper[2][2]};
    }
    transform.scale = vec3(scale);
    shear = mat3(1);
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            double value = upper[c][r] / scale[r];
            if (r > c || (r == c && !singular)) {
                value = r == c ? 1 : 0;
            } else if (!singular && std::abs(upper[c][r]) <= kRounding * glm::length(a[c])) {
                value = 0;
            }
            shear[c][r] = static_cast<float>(value);
        }
    }
}

}  // namespace lanthorn
