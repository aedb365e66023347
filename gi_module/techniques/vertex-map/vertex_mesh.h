// The points of a mesh at which light is estimated, and the triangles that it is interpolated over: vertices
// that lie in one place and face one way share one estimate ("corners", Jozwowski 2002, sec. 4.4.2, fig. 20),
// and triangles too coarse for their light are subdivided (sec. 4.3).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// What a mesh is made of, by vertex, and 3 indices a triangle.
struct MeshShape {
    std::span<const vec3> positions;
    std::span<const vec3> normals;
    std::span<const std::uint32_t> indices;
};

// A point of the mesh by three of its vertices and their weights, which stays where the mesh goes.
struct Corner {
    std::array<std::uint32_t, 3> vertices{};
    vec3 weights{1, 0, 0};

    template <class T>
    T of(std::span<const T> values) const {
        return values[vertices[0]] * weights.x + values[vertices[1]] * weights.y +
               values[vertices[2]] * weights.z;
    }
};

// A corner in the middle of an edge of a coarser triangle: its light is what that triangle has there, or the
// picture would have a step along the edge.
struct HangingCorner {
    std::uint32_t corner = 0;
    std::uint32_t from = 0, to = 0;  // corners that the coarser edge has on either side of it
    float share = 0;                 // of `to`
};

struct VertexMesh {
    std::vector<Corner> corners;
    std::vector<std::uint32_t> triangles;  // 3 corners each
    std::vector<std::uint32_t> sources;    // triangle of the mesh that each lies in
    std::vector<std::uint32_t> firsts;     // by triangle of the mesh: the first of those, the rest follow
    std::vector<HangingCorner> hanging;    // none refers to another one
};

// A triangle is split into 4^level at most at this level.
inline constexpr std::uint8_t kMostLevels = 7;

// Cosine between the normals of vertices that share a corner.
inline constexpr float kSharedCorner = 0.9f;

// `levels`: by triangle, what it is split to: edges of 1 / 2^level. `shared`: whether corners are; else every
// triangle has three of its own, as the thesis begins with. O(result).
VertexMesh make_vertex_mesh(const MeshShape& shape, std::span<const std::uint8_t> levels, bool shared);

// Which of the pieces that a triangle is split into at `level` has the point with those weights of the
// triangle's corners, and the weights of the piece's own, in the order of VertexMesh::triangles. O(1).
struct PieceAt {
    std::uint32_t piece = 0;
    vec3 weights{1, 0, 0};
};
PieceAt piece_at(std::uint8_t level, const vec3& weights);

// The level at which a triangle's longest edge is at most `edge` metres, in the space of `positions`.
std::uint8_t level_for_edge(float longest, float edge);

}  // namespace lanthorn::gi
