// What is kept of each entity whose meshes deform, and the pieces of work that a frame consists of. Pieces of
// one kind may run at the same time, in any order.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/deformation/frame_pool.h"
#include "engine/deformation/mesh_library.h"
#include "engine/deformation/pose.h"
#include "lanthorn/deformation/detail.h"

namespace lanthorn::deform {

struct MeshState {
    std::uint32_t index = 0;                       // slot of the assets' meshes
    std::shared_ptr<const PreparedMesh> mesh;      // null: does not deform
    std::vector<ActiveMorph> morphs, next_morphs;  // of the output, of this frame
    std::uint32_t level = 0;                       // of the output's refinement; 0: none
    std::vector<VertexFrame> cage;                 // deformed, where there is a surface over it
    std::vector<Lanes> controls;                   // the surface's control points
    FramePool pool;
    DeformedMesh output;
    bool stale = true;  // the output is not this frame's
};

struct EntityState {
    ecs::Entity entity;
    std::uint64_t seen = 0;  // update
    PoseSources sources;
    Pose pose, next_pose;  // of the outputs, of this frame
    std::vector<MeshState> meshes;
    std::string_view pose_problem, weights_problem;
};

// Some blocks of one mesh.
struct Job {
    const EntityState* entity;
    const MeshState* mesh;
    VertexFrame* to;
    std::uint32_t first_block, end_block;
    BoundsLanes bounds;
};

// Some vertices of one surface.
struct RefineJob {
    const LimitStencils* stencils;
    const MeshState* mesh;
    VertexFrame* to;
    std::uint32_t first, end;
    bool mirrored;
    BoundsLanes bounds;
};

// Null without a cage, or if it cannot be subdivided.
SubdivisionSurface* surface_of(const MeshState& mesh);

// Whether its vertices are anywhere but in the bind pose.
bool moves(const EntityState& entity, const MeshState& mesh);

// A box that holds the mesh wherever its joints take it, and how long its cage's edges can be there. Needs a
// surface.
Extent extent_of(const EntityState& entity, const MeshState& mesh);

// Morphs and skins.
void run(Job& job);
// Between the two: fills `controls` from `cage`, or from the bind pose. Needs a surface.
void gather_controls(const EntityState& entity, MeshState& mesh);
// Refines.
void run(RefineJob& job);

}  // namespace lanthorn::deform
