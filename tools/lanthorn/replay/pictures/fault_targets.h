// What faults of pictures are made of: what matters most in what a mark sees, so that a fault is one that
// somebody could see.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lanthorn/scene/components.h"
#include "tools/lanthorn/replay/pictures/drawn_mark.h"

namespace lanthorn::tools {

struct FaultTargets {
    ecs::Entity lamp;   // without which most light is lost; null: none lights anything there
    ecs::Entity mover;  // has moved, and takes most light from what is not itself; null: none does
    std::string lamp_name, mover_name;
};

// By direct light alone, in small pictures: one with each lamp off, one without each mover.
FaultTargets fault_targets(const MarkArtist& artist, const MarkedMoment& at, const MarkView& view);

// Takes the meshes of an entity and of all below it out of the world, and returns them.
using Hidden = std::vector<std::pair<ecs::Entity, MeshInstances>>;
Hidden hide(ecs::World& world, ecs::Entity root);

// Whether another surface is seen at a pixel or right beside it: two depths (MarkPicture::depth) of one size.
bool sees_other(const ImageF& a, const ImageF& b, int x, int y);

}  // namespace lanthorn::tools
