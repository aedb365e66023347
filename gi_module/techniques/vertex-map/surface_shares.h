// What of the circle about a point is surface, so that an estimate at a wall's edge or corner is not dark for
// want of photons beyond it (the "boundary bias" of Lavignotte and Paulin 2003, sec. 4.1, here for the
// nearest photons).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/techniques/vertex-map/area_tree.h"
#include "gi_module/techniques/vertex-map/radiance_estimate.h"

namespace lanthorn::gi {

// The triangles of one instance, where they can be found by place.
class SurfaceTriangles {
  public:
    static constexpr std::size_t kMany = 8192;

    // `positions` in render space; `reach`: metres, the largest radius that will be asked for. O(triangles),
    // and 108 bytes or so each where they are small beside `reach`.
    SurfaceTriangles(std::span<const vec3> positions, std::span<const std::uint32_t> indices, float reach);

    // By exact areas of triangles within spheres about the point, over those of the circle: triangles whose
    // normal is within kSameSurface of `normal`, on either side if `both_sides`. Of more than kMany triangles
    // those that are small beside their distance count by groups, within a hundredth or so. O(triangles near
    // by), O(log triangles) of many.
    SurfaceShares about(const vec3& point, const vec3& normal, bool both_sides) const;

  private:
    ivec3 cell_of(const vec3& p) const;
    std::size_t index_of(const ivec3& cell) const;

    void add(const SurfaceTriangle& triangle, const vec3& point, const vec3& normal, bool both_sides,
             AreaTree::Areas& areas) const;

    std::vector<SurfaceTriangle> triangles_;
    AreaTree tree_;  // of many; then there are no cells
    float reach_;
    vec3 lower_{0};
    vec3 per_metre_{0};  // cells a metre
    ivec3 cells_{1};
    std::vector<std::uint32_t> first_;  // by cell, one more than there are
    std::vector<std::uint32_t> list_;   // of triangles within reach of each cell
};

}  // namespace lanthorn::gi
