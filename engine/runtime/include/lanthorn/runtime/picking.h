// What lies under a pixel of a view, or along a ray: shapes by their triangles as the last frame showed them,
// skinned and refined ones too, lights and cameras by spheres that stand for their icons.
//
//   for (const Picked& thing : pick(app, ViewId::first, cursor)) { ... }   // the nearest first
//
// Exact rays on the CPU rather than numbers read back from the picture: what lies behind glass is found too,
// edges have no half-covered pixels, and nothing waits for the GPU.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// The ray along which is looked, with the width of the pixel that it goes through.
struct PickRay {
    dvec3 origin{0};            // world space, metres
    dvec3 direction{0, 0, -1};  // unit
    double nearest = 0;         // metres along it: nothing nearer is found, nor
    double farthest = std::numeric_limits<double>::infinity();
    // How wide a pixel is: metres a metre from the origin, and metres more (orthographic). 0: no pixels.
    double pixel_spread = 0, pixel_width = 0;
};

// Through `pixel` of a picture of `size`, from the upper left; (0.5, 0.5) is the first pixel's centre. From
// the camera's near plane to its far plane. `origin`: FrameScene::origin.
PickRay pick_ray(const CameraView& look, const dvec3& origin, ivec2 size, const glm::dvec2& pixel);

// What stands under the pixel: a mesh's triangle, or the sphere of a light or camera.
enum class PickedKind { shape, light, camera };

// What the ray has met first.
struct Picked {
    PickedKind kind = PickedKind::shape;
    ecs::Entity entity;
    double distance = 0;  // metres from the ray's origin
    dvec3 position{0};    // world space
    // Of shapes:
    dvec3 normal{0};             // unit, of the triangle, towards the ray's origin
    std::uint32_t mesh = 0;      // slot of FrameScene::assets' meshes
    std::uint32_t triangle = 0;  // of InstanceShape::indices(), by threes
};

// What is looked for.
struct PickOptions {
    bool shapes = true;
    bool lights = true;   // that are placed: all but the sky
    bool cameras = true;  // but the one that the ray is looked along with
    // Radius of the spheres of lights and cameras: metres, or pixels where those are wider. What the ray
    // starts in is not found.
    double icon_metres = 0.1;
    double icon_pixels = 8;
    ecs::Entity through = ecs::kNullEntity;  // the camera to leave out
};

// Along a ray, the nearest first; of each mesh of an entity the nearest triangle. As the picture shows them:
// back faces of single-sided materials and what is cut out of masked ones are looked through; blended and
// transparent surfaces are found, and what is behind them is too. Entities that have been destroyed since
// `scene` was extracted are left out (one that took such an entity's number stands for it). O(instances), and
// O(triangles) of those whose box the ray meets; edges between triangles leave no gap.
std::vector<Picked> pick(const ecs::World& world, const FrameScene& scene, const PickRay& ray,
                         const PickOptions& options = {});

// Under a pixel of what a view has shown in the last frame. Throws Error if it was not drawn.
std::vector<Picked> pick(App& app, ViewId view, const glm::dvec2& pixel, PickOptions options = {});

}  // namespace lanthorn
