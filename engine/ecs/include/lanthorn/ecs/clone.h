// Entities as copies of others: prefabs, duplicates in an editor.
#pragma once

#include <span>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

// An entity for each of `originals`, with copies of all its components; what hooks keep (`derived`)
// comes by the hooks. References among the originals
// become references among the copies; those to other entities stay. Throws Error for a dead entity, or a
// component that is not declared. Cost: that of adding the components one by one.
std::vector<Entity> clone(World& world, const Registry& registry, std::span<const Entity> originals);

// The same from another world: a prefab's. References to entities that are not copied become null.
std::vector<Entity> clone_from(World& world, const World& from, const Registry& registry,
                               std::span<const Entity> originals);

}  // namespace lanthorn::ecs
