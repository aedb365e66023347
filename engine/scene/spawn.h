// From a loaded scene to entities.
#pragma once

#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// The resource that holds what meshes, materials and images the world's entities refer to.
using SharedAssets = std::shared_ptr<const SceneAssets>;

// One entity a node, in the nodes' order: result[i] is nodes[i]. The meshes, materials, textures and images
// join those of scenes spawned before: a new SharedAssets resource with another serial takes the old one's
// place. World transforms are up to date. Nodes with a skin get a SkinInstance, those whose meshes have morph
// targets MorphWeights; a scene with animations gets one more entity, which has its AnimationSet and nothing
// else. The second form takes the assets out of `scene` instead of copying them.
std::vector<ecs::Entity> spawn(ecs::World& world, const SceneData& scene);
std::vector<ecs::Entity> spawn(ecs::World& world, SceneData&& scene);

// Destroys `root` and everything below it. O(entities with a Parent).
void destroy_tree(ecs::World& world, ecs::Entity root);

// The first entity of that name in storage order, or the null entity.
ecs::Entity find_by_name(ecs::World& world, std::string_view name);

}  // namespace lanthorn
