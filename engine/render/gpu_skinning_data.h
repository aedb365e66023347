// What gpu_skinning.comp reads (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_GPU_SKINNING_DATA_H
#define LANTHORN_GPU_SKINNING_DATA_H

#ifdef __cplusplus
#include <cstdint>

namespace lanthorn::render {
using uint = std::uint32_t;
#define LANTHORN_CONST constexpr
#else
#define LANTHORN_CONST const
#endif

// Storage buffer bindings: as many as OpenGL 4.5 promises.
LANTHORN_CONST uint kBindPoseBinding = 0u;     // float, 10 a vertex: VertexFrame
LANTHORN_CONST uint kFirstRoundBinding = 1u;   // uint, one a group of four vertices, and the end
LANTHORN_CONST uint kRoundsBinding = 2u;       // InfluenceRound
LANTHORN_CONST uint kJointsBinding = 3u;       // vec4, three rows a matrix
LANTHORN_CONST uint kMorphListBinding = 4u;    // uint: the vertices of sparse targets
LANTHORN_CONST uint kMorphDeltasBinding = 5u;  // float
LANTHORN_CONST uint kMorphsBinding = 6u;       // ActiveMorphData
LANTHORN_CONST uint kFramesBinding = 7u;       // float, 10 a vertex: the result

// One influence of each of a group's four vertices.
struct InfluenceRound {
    uint joints_01;  // two 16-bit indices, the lower vertex in the lower half
    uint joints_23;
    float weight_0, weight_1, weight_2, weight_3;
};

LANTHORN_CONST uint kNoDeltas = 0xffffffffu;

// Where the deltas of a target that is on are. Sparse: x, y, z for each listed vertex. Dense: for each group
// of four vertices four x, four y, four z.
struct ActiveMorphData {
    uint dense;
    uint first;  // sparse: of its vertices in the list
    uint count;
    float weight;
    uint positions;  // offsets; kNoDeltas: none
    uint normals;
    uint tangents;
    uint reserved;
};

// How vertices are placed.
LANTHORN_CONST int kPlaceAsTheyAre = 0;
LANTHORN_CONST int kPlaceByOneMatrix = 1;  // the last of the joints
LANTHORN_CONST int kPlaceBySkin = 2;

#ifdef __cplusplus
static_assert(sizeof(InfluenceRound) == 24);
static_assert(sizeof(ActiveMorphData) == 32);
}  // namespace lanthorn::render
#endif
#undef LANTHORN_CONST
#endif
