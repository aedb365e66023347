// A mesh packed for deformation, once: its vertices in groups of four, who moves them, and where they are
// moved to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/deformation/vertex_group.h"
#include "lanthorn/scene/mesh.h"

namespace lanthorn::deform {

// The influences of the vertices, in rounds: round k of a group holds the k-th influence of its four
// vertices. A group has as many rounds as its busiest vertex has influences, so four cost half of eight.
struct SkinStream {
    struct Joints {
        std::uint16_t of[kLanes];
    };
    std::vector<std::uint32_t> first_round;  // one a group, and the end
    std::vector<Joints> joints;              // one a round; a lane without influence has joint 0 ...
    std::vector<Lanes> weights;              // ... at weight 0
    std::uint16_t last_joint = 0;            // the greatest index in use

    bool empty() const { return weights.empty(); }
};

// One morph target: a list of vertices, or (`dense`) all of them.
struct MorphStream {
    bool dense = false;
    std::vector<std::uint32_t> vertices;     // sparse: ascending
    std::vector<std::uint32_t> block_first;  // sparse: where each block starts in `vertices`, and the end
    // x, y, z one after another for each listed vertex (sparse) or group of four (dense); empty: not moved.
    std::vector<float> positions, normals, tangents;
};

struct BindPose {
    std::uint32_t vertex_count = 0;
    std::vector<VertexGroup> groups;  // the last is filled up with its last vertex
    SkinStream skin;                  // empty: none
    std::vector<MorphStream> morphs;
    std::vector<float> morph_weights;  // Mesh::morph_weights

    std::uint32_t block_count() const { return (vertex_count + kBlockVertices - 1) / kBlockVertices; }
};

// Weights are scaled to sum to 1; a vertex that has none follows its first joint. O(vertices + morph deltas).
BindPose pack(const Mesh& mesh);

}  // namespace lanthorn::deform
