// The components of scene nodes. Whoever moves things writes LocalTransform; Transforms derives
// WorldTransform from it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/math.h"
#include "engine/ecs/entity.h"
#include "engine/scene/camera.h"
#include "engine/scene/light.h"
#include "engine/scene/scene_data.h"

namespace lanthorn {

struct Name {
    std::string value;
};

// Relative to the parent, or to the world for an entity without Parent.
struct LocalTransform {
    Transform value;
    bool operator==(const LocalTransform&) const = default;
};

// What a glTF matrix has beyond translation, rotation and scale: local = T * R * S * shear. Rare.
struct Shear {
    mat3 value{1};
};

// The entity must be alive and have a LocalTransform.
struct Parent {
    ecs::Entity entity;
    bool operator==(const Parent&) const = default;
};

// Object to world space. Written by Transforms alone.
struct WorldTransform {
    dmat4 matrix{1};
    bool operator==(const WorldTransform&) const = default;
};

// Indices into SceneAssets::meshes, all drawn at the entity's WorldTransform.
struct MeshInstances {
    std::vector<std::uint32_t> meshes;
};

struct LightComponent {
    Light light;
};

struct CameraComponent {
    Camera camera;
};

// The node's `extras` as JSON text.
struct Extras {
    std::string json;
};

}  // namespace lanthorn
