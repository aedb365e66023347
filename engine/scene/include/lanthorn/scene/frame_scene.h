// FrameScene: the immutable snapshot of what the renderer and the GI need of one frame.
//
// Everything is in *render space*: world space moved so that `origin` (double precision, near the scene's
// centre, constant while the scene stays where it is) is at 0. Nothing after extraction knows absolute world
// positions.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/camera.h"
#include "lanthorn/scene/deformed_mesh.h"
#include "lanthorn/scene/light.h"
#include "lanthorn/scene/scene_assets.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

// One mesh placed in the scene.
struct Instance {
    static constexpr std::uint32_t kNotDeformed = 0xffffffffu;

    std::uint32_t id = 0;                   // stable over frames: the entity's index
    std::uint32_t mesh = 0;                 // slot of SceneAssets::meshes; the material is the mesh's
    std::uint32_t deformed = kNotDeformed;  // into FrameScene::deformed, whose vertices then are drawn
    std::uint32_t generation = 0;           // the entity's: another entity of that index has another one
    std::uint64_t version = 0;              // DeformedMesh::version, 0 without
    mat4 transform{1};                      // object (or deformed vertices') to render space
    Aabb bounds;                            // render space
    bool is_static = false;  // neither moved nor deformed for the last kStaticAfter extractions

    bool operator==(const Instance&) const = default;
};

// One punctual light placed in the scene.
struct LightInstance {
    std::uint32_t id = 0;  // stable over frames
    Light light;
    vec3 position{0};          // render space
    vec3 direction{0, 0, -1};  // unit, the way the light shines

    bool operator==(const LightInstance&) const = default;
};

// One light sensor placed in the scene.
struct SensorInstance {
    std::uint32_t id = 0;                    // stable over frames: the entity's index
    vec3 position{0};                        // render space
    vec3 direction{0, 0, -1};                // unit, the way it looks
    float radius = 0;                        // metres
    vec3 filter{0.2126f, 0.7152f, 0.0722f};  // what a lux of red, green, blue counts

    bool operator==(const SensorInstance&) const = default;

    // What it measures in `illuminance` (lux, red, green and blue): lux where the filter is luminance.
    float reading(const vec3& illuminance) const { return glm::dot(filter, illuminance); }
};

// The sky behind the scene.
struct SkyInstance {
    std::uint32_t id = 0;  // stable over frames: the entity's index
    Sky sky;               // its images are not null
    mat3 to_sky{1};        // rotation from render space into the images' axes

    vec3 scale() const { return sky.colour * sky.intensity; }  // from the image's radiance to nits, rgb
    bool operator==(const SkyInstance&) const = default;
};

// A camera where it is in this frame.
struct CameraView {
    Camera camera;
    mat4 view{1};      // render space to view space (rigid)
    vec3 position{0};  // render space

    bool operator==(const CameraView&) const = default;
};

// The projection of `camera` for an image of `aspect` = width / height, OpenGL clip space (-1..1).
mat4 projection_matrix(const Camera& camera, float aspect, float scene_diagonal);

// What differs from the FrameScene before; the first has everything set.
struct SceneChanges {
    bool assets = true;    // any mesh, material, texture or image (SceneAssets::serial)
    bool geometry = true;  // any instance added, removed, moved, or of another shape or surface
    bool lights = true;    // any light added, removed or altered; the sky is one of them
    bool camera = true;
    // Indices into `instances` of those added or moved, or whose mesh or what of it its material shows
    // (holes, sides) is another.
    std::vector<std::uint32_t> moved;
    Aabb dirty;  // render space: where geometry was or is, of all these and of those removed

    bool replaced = false;               // nothing of what was there before is left
    std::vector<std::uint32_t> arrived;  // of `moved`: those that were not there before
    std::vector<std::uint32_t> painted;  // indices of those whose material reflects diffusely otherwise
    bool pattern = false;                // of one of these more than the base colour: maps of it are outdated
    bool emission = false;               // the material of an instance emits otherwise
    bool relief = false;                 // the material of an instance has another normal map
    // Slots of SceneAssets that hold another asset, or another version of it, or nothing any more.
    std::vector<std::uint32_t> meshes, materials, images;

    // For GI: the camera alone changes nothing traced.
    bool nothing() const { return !geometry && !lights && painted.empty() && !emission; }
};

struct FrameScene {
    std::uint64_t frame = 0;                    // counts extractions
    dvec3 origin{0};                            // world position of render-space 0
    std::shared_ptr<const SceneAssets> assets;  // never null
    std::vector<Instance> instances;            // sorted by id, then mesh
    std::vector<DeformedMesh> deformed;         // by instance
    std::vector<LightInstance> lights;          // sorted by id
    std::vector<SensorInstance> sensors;        // sorted by id
    std::optional<SkyInstance> sky;             // none: black
    CameraView camera;
    Aabb bounds;  // of all instances; empty without geometry
    SceneChanges changes;

    // The instance's own, undeformed.
    const Mesh& mesh(const Instance& instance) const { return assets->meshes[instance.mesh]; }
    // Of the instance's mesh.
    const Material& material(const Instance& instance) const {
        return assets->materials[mesh(instance).material];
    }

    // To tell whether the mesh is another than before.
    const AssetVersion<Mesh>& mesh_version(const Instance& instance) const {
        return assets->meshes.version(instance.mesh);
    }
    // Likewise, of its material.
    const AssetVersion<Material>& material_version(const Instance& instance) const {
        return assets->materials.version(mesh(instance).material);
    }

    // The length that tolerances are relative to: the bounds' diagonal, or 1 for an empty scene.
    float diagonal() const { return bounds.empty() || !(bounds.diagonal() > 0) ? 1.0f : bounds.diagonal(); }
};

}  // namespace lanthorn
