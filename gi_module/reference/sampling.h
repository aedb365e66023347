// Directions and points drawn from densities, and how two ways of drawing are weighed against each other.
#pragma once

#include <algorithm>
#include <cmath>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/math.h"

namespace lanthorn::reference {

inline float largest(const vec3& colour) {
    return std::max({colour.x, colour.y, colour.z});
}

// Carries nothing. What is not a number is not black: it has to be found and counted.
inline bool is_black(const vec3& colour) {
    return colour.x == 0 && colour.y == 0 && colour.z == 0;
}

// Without a jump, as loops over lanes need it.
inline vec3 select(bool condition, const vec3& a, const vec3& b) {
    return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

inline vec3 unit(const vec3& v) {
    return v * (1 / std::sqrt(glm::dot(v, v)));
}

// Two axes square to unit `n` and to each other (Duff et al. 2017, "Building an Orthonormal Basis,
// Revisited").
template <class T>
struct BasisOf {
    using Vector = glm::vec<3, T>;
    Vector tangent, bitangent, normal;

    explicit BasisOf(const Vector& n) : normal(n) {
        const T s = std::copysign(T(1), n.z);
        const T a = T(-1) / (s + n.z);
        const T b = n.x * n.y * a;
        tangent = Vector(T(1) + s * n.x * n.x * a, s * b, -s * n.x);
        bitangent = Vector(b, s + n.y * n.y * a, -n.y);
    }
    Vector to_world(const Vector& v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
    Vector to_local(const Vector& v) const {
        return {glm::dot(v, tangent), glm::dot(v, bitangent), glm::dot(v, normal)};
    }
};
using Basis = BasisOf<float>;

// The point on the unit circle after `turns` of it, 0 <= turns < 1, to 1e-7: Taylor's series over an eighth
// of a turn to either side. Several times faster than the library's functions, which were a tenth of the
// time.
inline vec2 on_circle(float turns) {
    const int q = (static_cast<int>(8.0f * turns) + 1) / 2;
    const float a = (turns - 0.25f * static_cast<float>(q)) * (2.0f * kPi);
    const float a2 = a * a;
    const float s =
        a * (1 + a2 * (-1.0f / 6 + a2 * (1.0f / 120 + a2 * (-1.0f / 5040 + a2 * (1.0f / 362880)))));
    const float c = 1 + a2 * (-0.5f + a2 * (1.0f / 24 + a2 * (-1.0f / 720 + a2 * (1.0f / 40320))));
    const vec2 p = (q & 1) != 0 ? vec2(-s, c) : vec2(c, s);
    return (q & 2) != 0 ? -p : p;
}

// A direction about unit `n` with density cos / pi, from u in [0, 1)^2 (Malley's method).
[[gnu::always_inline]] inline vec3 cosine_direction(const vec3& n, const vec2& u) {
    const vec2 p = on_circle(u.y) * std::sqrt(u.x);
    return Basis(n).to_world({p.x, p.y, std::sqrt(std::max(1.0f - u.x, 0.0f))});
}

// Barycentric weights of a point spread evenly over a triangle (Osada et al. 2002, eq. 1).
[[gnu::always_inline]] inline vec3 triangle_point(const vec2& u) {
    const float root = std::sqrt(u.x);
    return {1.0f - root, root * (1.0f - u.y), root * u.y};
}

// Weight of a sample drawn with density `drawn` where `other` could have drawn it too: the power heuristic
// with exponent 2 (Veach 1997, eq. 9.13). Written so that neither may overflow.
inline float power_heuristic(float drawn, float other) {
    const float ratio = other / drawn;
    return drawn > 0 ? 1.0f / (1.0f + ratio * ratio) : 0.0f;
}

}  // namespace lanthorn::reference
