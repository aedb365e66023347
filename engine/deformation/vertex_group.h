// Four vertices as a structure of arrays: what morphs and skinning work on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/deformation/lanes.h"
#include "lanthorn/core/math.h"
#include "lanthorn/scene/deformed_mesh.h"

namespace lanthorn::deform {

struct VertexGroup {
    std::array<Lanes, 3> position;
    std::array<Lanes, 3> normal;
    std::array<Lanes, 3> tangent;
    Lanes sign;  // the tangent's w
};

// Groups that are worked on together, small enough for the first-level cache.
inline constexpr std::uint32_t kBlockGroups = 64;
inline constexpr std::uint32_t kBlockVertices = kBlockGroups * kLanes;

inline void set_lane(std::array<Lanes, 3>& to, std::uint32_t lane, const vec3& v) {
    to[0][lane] = v.x;
    to[1][lane] = v.y;
    to[2][lane] = v.z;
}

inline vec3 lane_of(const std::array<Lanes, 3>& from, std::uint32_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

inline Lanes dot(const std::array<Lanes, 3>& a, const std::array<Lanes, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The smallest box of many vertices, four at a time.
class BoundsLanes {
  public:
    void add(const std::array<Lanes, 3>& p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower_[axis] = least(p[axis], lower_[axis]);
            upper_[axis] = greatest(p[axis], upper_[axis]);
            // 0 times what is not finite is not 0.
            poison_ += p[axis] * 0.0f;
        }
    }
    // Whether all vertices were.
    bool finite() const { return poison_[0] + poison_[1] + poison_[2] + poison_[3] == 0; }
    Aabb box() const {
        Aabb result;
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            result.lower = glm::min(result.lower, lane_of(lower_, lane));
            result.upper = glm::max(result.upper, lane_of(upper_, lane));
        }
        return result;
    }

  private:
    static constexpr float kFar = std::numeric_limits<float>::infinity();
    std::array<Lanes, 3> lower_{splat(kFar), splat(kFar), splat(kFar)};
    std::array<Lanes, 3> upper_{splat(-kFar), splat(-kFar), splat(-kFar)};
    Lanes poison_{};
};

// Makes `v` unit length in the lanes where it is neither too short nor too long to be squared; elsewhere asks
// `otherwise(lane)` for a unit vector.
template <class Otherwise>
inline void normalise(std::array<Lanes, 3>& v, const Otherwise& otherwise) {
    const Lanes squared = dot(v, v);
    const auto fair = (squared > splat(1e-30f)) & (squared < splat(1e30f));
    const Lanes scale = splat(1) / square_root(squared);
    for (Lanes& x : v) {
        x *= scale;
    }
    if (fair[0] & fair[1] & fair[2] & fair[3]) {
        return;
    }
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        if (!fair[lane]) {
            set_lane(v, lane, otherwise(lane));
        }
    }
}

// `v` at unit length whatever its length, or `fallback` if it has no direction.
inline vec3 unit_or(const dvec3& v, const vec3& fallback) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
        return fallback;
    }
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 ? vec3(glm::normalize(v / largest)) : fallback;
}

// Writes the first `count` (1..4) vertices of the group.
inline void write(const VertexGroup& group, std::uint32_t count, VertexFrame* to) {
    static_assert(sizeof(VertexFrame) == 10 * sizeof(float));
    Lanes a[4] = {group.position[0], group.position[1], group.position[2], group.normal[0]};
    Lanes b[4] = {group.normal[1], group.normal[2], group.tangent[0], group.tangent[1]};
    Lanes c[4] = {group.tangent[2], group.sign, group.tangent[2], group.sign};
    transpose(a[0], a[1], a[2], a[3]);
    transpose(b[0], b[1], b[2], b[3]);
    transpose(c[0], c[1], c[2], c[3]);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        float* at = &to[lane].position.x;
        store(at, a[lane]);
        store(at + 4, b[lane]);
        at[8] = c[lane][0];
        at[9] = c[lane][1];
    }
}

}  // namespace lanthorn::deform
