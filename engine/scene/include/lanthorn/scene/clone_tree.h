// A node and all below it once more: a prefab, or a duplicate in an editor.
#pragma once

#include <vector>

#include "lanthorn/ecs/clone.h"

namespace lanthorn {

// The copies of `root`, which has the same parent, and of what is below it, parents before children.
// References within the tree are to the copies. Throws ecs::Error for a dead entity or a component that is
// not declared. O(components copied).
std::vector<ecs::Entity> clone_tree(ecs::World& world, const ecs::Registry& registry, ecs::Entity root);

}  // namespace lanthorn
