// The components of scene nodes. Whoever moves things writes LocalTransform; Transforms derives
// WorldTransform from it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/scene/animation_clip.h"
#include "lanthorn/scene/asset_handle.h"
#include "lanthorn/scene/asset_hold.h"
#include "lanthorn/scene/camera.h"
#include "lanthorn/scene/deformed_mesh.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/light.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

// What people call the entity: its node's name, not unique.
struct Name {
    std::string value;
};

// Relative to the Parent (hierarchy.h), or to the world for an entity without one.
struct LocalTransform {
    Transform value;
    bool operator==(const LocalTransform&) const = default;
};

// What a glTF matrix has beyond translation, rotation and scale: local = T * R * S * shear. Rare.
struct Shear {
    mat3 value{1};
};

// Object to world space. Written by Transforms alone.
struct WorldTransform {
    dmat4 matrix{1};
    bool operator==(const WorldTransform&) const = default;
};

// Meshes of the world's AssetStore, all drawn at the entity's WorldTransform. Altered by World::insert alone,
// since the store counts who refers to what. Refused with an InputError: a handle of what has been released
// or is in no store.
struct MeshInstances {
    std::vector<MeshHandle> meshes;
    std::vector<AssetHold<Mesh>> held = {};  // one for each of `meshes`; put there when the entity gets it

    bool operator==(const MeshInstances& other) const { return meshes == other.meshes; }
};

// Where the entity came from: node `node` of a file of the world's AssetStore. Likewise altered by insert,
// counted and refused.
struct Source {
    SceneHandle scene;
    std::uint32_t node = 0;           // into SceneAsset::nodes
    AssetHold<SceneAsset> held = {};  // on `scene`, as in MeshInstances

    bool operator==(const Source& other) const { return scene == other.scene && node == other.node; }
};

// The joints that pose the entity's skinned meshes.
struct SkinInstance {
    std::vector<ecs::Entity> joints;  // one a Skin::joints; need a WorldTransform
    std::vector<mat4> inverse_binds;  // likewise
};

// The weights of the entity's morph targets; a mesh with more targets takes 0 for the rest.
struct MorphWeights {
    std::vector<float> weights;
    bool operator==(const MorphWeights&) const = default;
};

// The clips of a loaded scene and the entities that they move, on the first root among these or above them.
struct AnimationSet {
    std::shared_ptr<const std::vector<AnimationClip>> clips;
    std::vector<ecs::Entity> nodes;  // AnimationChannel::node's entity
};

// What deformation made of the entity's meshes. Written by it alone, drawn instead of the meshes.
struct DeformedMeshes {
    // One for each of MeshInstances::meshes; without `vertices`: that mesh is not deformed.
    std::vector<DeformedMesh> meshes;
    // Where the vertices are in the world: of skinned meshes the joints say (glTF 2.0, 3.7.3.1: the node's
    // own transform is ignored), a translation near them; of others the entity's WorldTransform does.
    bool skinned = false;
    dvec3 skinned_at{0};
};

// A light; the entity's world transform places it.
struct LightComponent {
    Light light;
};

// The light that comes from far away all around; the entity's world rotation turns it. Of several the one of
// the lowest entity shines.
struct SkyComponent {
    Sky sky;
};

// A resource: the sky of a world in which no SkyComponent shines, in the world's axes. Not part of the
// simulation's state.
struct Backdrop {
    Sky sky;
};

// A camera; it looks along -Z of the entity's world transform.
struct CameraComponent {
    Camera camera;
};

// The node's `extras` as JSON text.
struct Extras {
    std::string json;
};

}  // namespace lanthorn

// Check the handles, and hold what they name.
template <>
struct lanthorn::ecs::Hooks<lanthorn::MeshInstances> {
    // Throws InputError for a mesh that is not alive in the world's AssetStore.
    static void check(const World& world, Entity e, const lanthorn::MeshInstances& value);
    // Holds the meshes, and lets go of those of the value before.
    static void on_add(World& world, Entity e);
};
// Checks the file, and holds it.
template <>
struct lanthorn::ecs::Hooks<lanthorn::Source> {
    // Throws InputError for a file that is not alive in the world's AssetStore. The null handle is allowed.
    static void check(const World& world, Entity e, const lanthorn::Source& value);
    // Holds the file, and lets go of that of the value before.
    static void on_add(World& world, Entity e);
};
