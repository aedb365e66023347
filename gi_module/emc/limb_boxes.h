// The boxes of a deforming mesh's limbs: one box around a whole figure is mostly air.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/deformed_mesh.h"

namespace lanthorn::gi {

// A mesh's vertices in groups that stay together: each triangle has all its corners in one of them.
class Limbs {
  public:
    Limbs() = default;
    // At most `most` groups, which have small boxes in this pose. O(most * triangles).
    Limbs(std::span<const VertexFrame> vertices, std::span<const std::uint32_t> indices, std::size_t most);

    // Of all groups, in another pose; vertices as many as there were. O(vertices).
    std::vector<Aabb> boxes(std::span<const VertexFrame> vertices, const mat4& transform) const;

  private:
    std::vector<std::uint32_t> vertices_;  // group by group
    std::vector<std::size_t> ends_;        // of the groups
};

}  // namespace lanthorn::gi
