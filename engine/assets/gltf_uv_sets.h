// Which of a file's sets of texture coordinates (TEXCOORD_n) a vertex holds: two, those that its material
// uses.
#pragma once

#include <array>
#include <cstdint>
#include <set>

namespace lanthorn {

using UvSets = std::array<std::uint32_t, 2>;  // by place in the vertex
inline constexpr UvSets kPlainUvSets{0, 1};

// For a material whose textures use the sets `used`. Sets 0 and 1 keep their places; a higher one takes a
// place that nothing of the material uses, the lowest first. Where more than two are used, some have no
// place.
UvSets choose_uv_sets(const std::set<std::uint32_t>& used);

}  // namespace lanthorn
