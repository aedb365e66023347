// What a mesh carries so that it can be deformed: skin influences, morph targets, a subdivision cage. Read on
// import, used by engine/deformation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

// JOINTS_0/1 and WEIGHTS_0/1 of one vertex: indices into Skin::joints. Weights sum to 1, the largest first;
// those past the last influence are 0.
struct SkinInfluences {
    static constexpr std::size_t kMost = 8;
    std::array<std::uint16_t, kMost> joints{};
    std::array<float, kMost> weights{};
    bool operator==(const SkinInfluences&) const = default;
};

// Differences to the mesh's own vertices, for those that the target moves alone. Object space.
struct MorphTarget {
    std::vector<std::uint32_t> vertices;  // into Mesh::vertices, ascending
    std::vector<vec3> positions;          // one a listed vertex
    std::vector<vec3> normals;            // one a listed vertex, or empty: none are moved
    std::vector<vec3> tangents;           // likewise
};

// How a cage becomes its limit surface (as OpenSubdiv has them): of any polygons, or of triangles alone.
enum class SubdivisionScheme : std::uint8_t { catmull_clark, loop };

// An edge of the cage that subdivision keeps sharp.
struct SubdivisionCrease {
    std::uint32_t from = 0, to = 0;  // into Mesh::vertices, the ends of an edge of the cage
    float sharpness = 0;             // 0: smooth; 10 or more: for ever sharp
    bool operator==(const SubdivisionCrease&) const = default;
};

// The mesh is the cage of a subdivision surface: its triangles, in order, are fans of these faces.
struct SubdivisionCage {
    SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
    std::uint32_t level = 1;                // uniform refinements, 1..5
    std::vector<std::uint32_t> face_sizes;  // corners; a face of n is the next n - 2 triangles. Empty: 3 each
    std::vector<SubdivisionCrease> creases;
};

}  // namespace lanthorn
