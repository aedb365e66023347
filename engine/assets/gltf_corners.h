// Which vertices a glTF primitive strings together: glTF 2.0, 3.7.2.1, figure "Primitive types".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/assets/gltf_context.h"

namespace lanthorn {

struct GltfCorners {
    const GltfContext& context;
    const tinygltf::Primitive& primitive;
    const std::string& place;  // the primitive's, for what is said of it
    std::size_t vertex_count;
};

// Of lists, strips and fans of triangles: three each. Indices that are none are refused.
std::vector<std::uint32_t> triangles_of(const GltfCorners& of);
// Of points, lines, strips and loops: two each, which are one and the same of a point. Likewise.
std::vector<std::uint32_t> stroke_ends_of(const GltfCorners& of);

}  // namespace lanthorn
