// Morph targets (glTF 2.0, 3.7.2.2): each attribute plus the weighted sum of the targets' differences.
#pragma once

#include <cstdint>
#include <span>

#include "engine/deformation/bind_pose.h"

namespace lanthorn::deform {

// A target that is on: its weight is not 0.
struct ActiveMorph {
    std::uint32_t target = 0;  // into BindPose::morphs
    float weight = 0;
    bool operator==(const ActiveMorph&) const = default;
};

// Adds the targets, in their order, to the groups of `block`, which `groups` holds as the bind pose has them.
// Normals and tangents that were moved are made unit length again; one that vanished is the bind pose's.
// O(the active targets' vertices in the block).
void add_morphs(const BindPose& pose, std::uint32_t block, std::span<const ActiveMorph> active,
                std::span<VertexGroup> groups);

}  // namespace lanthorn::deform
