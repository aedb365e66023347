// A convex region of space as half spaces, and which boxes reach into it: what a camera, a light's map or a
// face of a cube map sees.
#pragma once

#include <array>

#include "lanthorn/core/math.h"

namespace lanthorn {

class Frustum {
  public:
    static constexpr int kMostPlanes = 6;

    // All of space, cut by cut(). Planes are given relative to `origin`.
    explicit Frustum(const vec3& origin) : origin_(origin) {}

    // What a transform of (point - origin) to clip space keeps: -w <= x, y <= w, 0 <= z <= w. One that maps
    // infinity to z = 0 has no far plane.
    static Frustum of_clip(const mat4& clip_from_relative, const vec3& origin);

    // The quarter-turn pyramid that face `face` of a cube map around `centre` sees (engine/render/cube.glsl).
    static Frustum of_cube_face(const vec3& centre, int face);

    // Keeps the points p with dot(normal, p - origin) + offset >= 0. At most kMostPlanes times.
    void cut(const vec3& normal, float offset = 0);

    // Whether the box may reach into the region: never false for a box that does, within 1e-5 of the
    // distances involved, nor for one that is not finite; false for an empty one. True for some boxes that
    // stay outside near the region's edges. O(planes), in double precision.
    bool touches(const Aabb& box) const;

  private:
    vec3 origin_;
    int count_ = 0;
    std::array<vec4, kMostPlanes> planes_{};
};

}  // namespace lanthorn
