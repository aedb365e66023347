// From a loaded scene to entities, and from these back to the file.
#pragma once

#include <cstdint>
#include <string_view>
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
// Takes the assets out of `scene`.
std::vector<ecs::Entity> spawn(ecs::World& world, SceneData&& scene);

// The first entity of that name in storage order, or the null entity.
ecs::Entity find_by_name(ecs::World& world, std::string_view name);

// Where an entity stands in the file that it came from, by the file's own indices: what an editor gives
// GltfDocument to write an edit back. kNone: nowhere.
struct FilePlace {
    std::string_view source;     // the file; valid while its SceneAsset is. Empty: it came from none
    std::uint32_t node = kNone;  // kNone also for what the importer made: an instance, of its parent's node;
                                 // a sky and its suns
    std::uint32_t camera = kNone, light = kNone;  // several nodes may share one
    std::vector<FileMap::Primitive> meshes;       // of its node
};

// By the entity's Source: clones have it too, and a snapshot keeps it, in memory or restored from bytes on
// entities that live. O(its meshes).
FilePlace file_place(const ecs::World& world, ecs::Entity e);

// Back: the entities whose `what` (&FilePlace::node, light or camera) is `index`, clones and further spawns
// of the file among them, in storage order. O(entities that came from a file).
std::vector<ecs::Entity> entities_at(ecs::World& world, SceneHandle scene, std::uint32_t FilePlace::*what,
                                     std::uint32_t index);

// A material of the scene by its index in the file, and back; a null handle or kNone: it has none.
MaterialHandle material_at(const SceneAsset& scene, std::uint32_t index);
// kNone: the scene has no such material. O(materials).
std::uint32_t file_index(const SceneAsset& scene, MaterialHandle material);

}  // namespace lanthorn
