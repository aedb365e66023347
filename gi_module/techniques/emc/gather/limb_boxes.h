// The limbs of a deforming mesh: their boxes, since one box around a whole figure is mostly air, and how each
// moves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/deformed_mesh.h"

namespace lanthorn::gi {

// Where a mesh's vertices are.
struct Pose {
    std::span<const VertexFrame> vertices;
    mat4 transform{1};  // to render space
};

struct LimbMotion {
    Aabb before;    // render space, where its vertices were
    mat4 carry{1};  // from there to where they are
};

// A mesh's vertices in groups that stay together: each triangle has all its corners in one of them.
class Limbs {
  public:
    Limbs() = default;
    // At most `most` groups, which have small boxes in this pose. O(triangles log most).
    Limbs(std::span<const VertexFrame> vertices, std::span<const std::uint32_t> indices, std::size_t most);

    // Of all groups, in another pose; vertices as many as there were. O(vertices).
    std::vector<Aabb> boxes(std::span<const VertexFrame> vertices, const mat4& transform) const;

    // How each group has moved from one pose to the next: the rigid motion that is nearest to what its
    // vertices and their normals did. O(vertices).
    std::vector<LimbMotion> motions(const Pose& before, const Pose& now) const;

  private:
    std::vector<std::uint32_t> vertices_;  // group by group
    std::vector<std::size_t> ends_;        // of the groups
};

}  // namespace lanthorn::gi
