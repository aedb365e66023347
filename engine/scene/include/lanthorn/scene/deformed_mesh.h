// What deformation makes of a mesh in one frame. Written by engine/deformation, carried by the FrameScene.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

// What moves of a vertex; the rest of Vertex stays as it is.
struct VertexFrame {
    vec3 position{0};          // metres, in the space that DeformedMesh names
    vec3 normal{0, 0, 1};      // unit length
    vec4 tangent{1, 0, 0, 1};  // as Vertex::tangent
    bool operator==(const VertexFrame&) const = default;
};

// Triangles and what stays of a mesh that has another topology than its cage.
struct RefinedTopology {
    std::uint64_t serial = 0;  // unique in the process
    std::vector<vec2> uv0, uv1;
    std::vector<vec4> colours;
    std::vector<std::uint32_t> indices;  // 3 a triangle, counter-clockwise front
};

struct DeformedMesh {
    std::uint64_t version = 0;  // unique in the process: another one whenever a vertex differs
    std::shared_ptr<const std::vector<VertexFrame>> vertices;  // one a vertex of the mesh, or of `refined`
    std::shared_ptr<const RefinedTopology> refined;            // null: the mesh's own triangles
    Aabb bounds;                                               // of the vertices
};

}  // namespace lanthorn
