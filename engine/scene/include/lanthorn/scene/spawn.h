// From a loaded scene to entities.
#pragma once

#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// One entity a node, in the nodes' order: result[i] is nodes[i], and has Source {scene, i}. Meshes,
// materials, textures, images and clips are the store's, shared by all that were spawned from the same file:
// O(nodes). World transforms are up to date. Nodes with a skin get a SkinInstance, those whose meshes have
// morph targets MorphWeights. The AnimationSet of a scene with animations is on the first of its roots that a
// clip moves, or has below it what a clip moves; it goes when that tree is destroyed. Throws InputError for a
// scene that has been released.
std::vector<ecs::Entity> spawn(ecs::World& world, SceneHandle scene);
// The same after asset_store(world).add(scene): O(data) to find out whether it is there already. The second
// form takes the assets out of `scene` instead of copying them.
std::vector<ecs::Entity> spawn(ecs::World& world, const SceneData& scene);
std::vector<ecs::Entity> spawn(ecs::World& world, SceneData&& scene);

// The first entity of that name in storage order, or the null entity.
ecs::Entity find_by_name(ecs::World& world, std::string_view name);

}  // namespace lanthorn
