// Linear blend skinning (glTF 2.0, 3.7.3.1 to 3.7.3.3): each vertex by the weighted sum of its joints'
// matrices.
#pragma once

#include <cstdint>
#include <span>

#include "engine/deformation/bind_pose.h"

namespace lanthorn::deform {

// The upper three rows of an affine matrix: x' = rows[0].xyz . x + rows[0].w, ...
struct JointMatrix {
    Lanes rows[3];
};

// What moves a vertex from the bind pose to where the joint carries it, relative to the world position `at`:
// translate(-at) * joint * inverse_bind, in double precision, so that it holds far from the world's origin.
JointMatrix joint_matrix(const dmat4& joint, const mat4& inverse_bind, const dvec3& at);

mat4 matrix(const JointMatrix& m);
bool finite(const JointMatrix& m);
// Left becomes right.
bool mirrors(const JointMatrix& m);

// Skins the vertices of groups [first_group, first_group + groups.size()), given in `groups` as morphs left
// them, and writes those that exist to to[0..). Normals go by the inverse transpose of the blended matrix, so
// that no scale or mirror bends them, tangents by the matrix; a tangent's sign turns under a mirror. Where a
// matrix leaves a direction no length the bind pose's stays. Adds to `bounds`. `joints` holds those of
// pose.skin.last_joint and below, all finite. O(influences); about 10 ns a vertex of four.
void skin_groups(const BindPose& pose, std::span<const JointMatrix> joints, std::uint32_t first_group,
                 std::span<const VertexGroup> groups, VertexFrame* to, BoundsLanes& bounds);

// The same with one matrix for all.
void move_groups(const BindPose& pose, const JointMatrix& matrix, std::uint32_t first_group,
                 std::span<const VertexGroup> groups, VertexFrame* to, BoundsLanes& bounds);

// No matrix: writes the groups as they are.
void copy_groups(const BindPose& pose, std::uint32_t first_group, std::span<const VertexGroup> groups,
                 VertexFrame* to, BoundsLanes& bounds);

}  // namespace lanthorn::deform
