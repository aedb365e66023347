// GLM as this project uses it (glTF space: metres, right-handed, +Y up, radians) and the small shapes on top.
#pragma once

#define GLM_FORCE_RADIANS
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace lanthorn {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::ivec3;
using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::uint;  // the shaders' name, in headers that both languages include
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float kPi = 3.14159265358979323846f;

// The value, or 0 where it is infinite or no number.
inline double finite_or_zero(double value) {
    return std::isfinite(value) ? value : 0;
}

// Axis-aligned box; empty (lower > upper) by default.
struct Aabb {
    vec3 lower{std::numeric_limits<float>::infinity()};
    vec3 upper{-std::numeric_limits<float>::infinity()};

    // Holds no point; a box of one point is not empty.
    bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
    // Grows to hold the point.
    void add(const vec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    // Grows to hold the box; the default, empty one changes nothing.
    void add(const Aabb& box) {
        lower = glm::min(lower, box.lower);
        upper = glm::max(upper, box.upper);
    }
    vec3 centre() const { return empty() ? vec3(0) : 0.5f * (lower + upper); }  // 0 of an empty box
    vec3 size() const { return empty() ? vec3(0) : upper - lower; }  // its edges; 0 of an empty box
    float diagonal() const { return glm::length(size()); }           // its length; 0 of an empty box
    bool operator==(const Aabb&) const = default;
};

// The box of `box` after the affine transform `m` (Arvo 1990). O(1).
Aabb transformed(const Aabb& box, const mat4& m);

}  // namespace lanthorn
