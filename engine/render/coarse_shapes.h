// Coarser triangles over a shape's own vertices, for maps whose texels are too wide to tell (meshoptimizer;
// Garland and Heckbert 1997, "Surface Simplification Using Quadric Error Metrics").
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::render {

struct CoarseLevel {
    std::vector<std::uint32_t> indices;  // 3 a triangle, into the shape's vertices
    float error = 0;  // how far it lies from the shape, a share of the diagonal of the shape's box
    float edge = 0;   // of its triangles, root mean square, the same share
};

// Fewer triangles than this are not worth a coarser list.
inline constexpr std::size_t kLeastCoarsened = 64;

// Finer ones first, each with three quarters of the triangles of the one before at most, none without any.
// Empty for small shapes. What deforms keeps its level's error nearly: limbs keep what lets them bend at
// their joints; what is refined, as far as it bends where it did in this pose. `textured`: edges of texture
// coordinates stay where they are; else they count for nothing. The same for the same shape. O(triangles log
// triangles), about 2 us a triangle.
std::vector<CoarseLevel> coarser_levels(const InstanceShape& shape, bool textured);

}  // namespace lanthorn::render
