// The surfaces of a mesh: connected triangles that bend little across their edges. A bandwidth is chosen for
// each, and photons light their own alone (Lavignotte and Paulin 2003, sec. 3.1, 3.3).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

struct SurfaceParts {
    std::vector<std::uint32_t> of_triangle;  // part, 0 .. count - 1
    std::vector<std::array<std::uint32_t, 3>>
        neighbours;  // across edges 01, 12, 20 on the same part, or none; copies have none
    std::vector<std::uint32_t> first_copy;  // of triangles that lie in one place, the first; else itself
    std::uint32_t count = 0;
};

// Edges are shared where their ends lie in the same places; across one the normals may turn by 35 degrees.
// Where more than two triangles share one, none of them go on across it. `indices`: 3 a triangle. O(n log n).
SurfaceParts surface_parts(std::span<const vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace lanthorn::gi
