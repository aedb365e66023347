// What an entity's meshes are deformed by in one frame, taken from its components.
#pragma once

#include <string_view>
#include <vector>

#include "engine/deformation/mesh_library.h"
#include "engine/deformation/morph.h"
#include "engine/deformation/skinning.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::deform {

struct Pose {
    bool skinned = false;
    dvec3 at{0};  // DeformedMeshes::skinned_at
    std::vector<JointMatrix>
        joints;  // skinned: the skin's; then, for meshes without influences, the entity's own
};

// The sources of a Pose; null where the entity lacks them.
struct PoseSources {
    const SkinInstance* skin = nullptr;
    const MorphWeights* weights = nullptr;
    const WorldTransform* transform = nullptr;
};

// Fills `pose`; `own_matrix`: the entity has meshes without influences. Returns what is wrong, empty if
// nothing; then `pose` is of no use. `last_joint`: the greatest that the meshes refer to. O(joints).
std::string_view take_pose(const ecs::World& world, const PoseSources& from, std::size_t last_joint,
                           bool own_matrix, Pose& pose);

// Fills `active` with the targets that are on. Weights that are not finite count as 0; returns what is wrong,
// empty if nothing. O(targets).
std::string_view take_weights(const MorphWeights* weights, const BindPose& mesh,
                              std::vector<ActiveMorph>& active);

}  // namespace lanthorn::deform
