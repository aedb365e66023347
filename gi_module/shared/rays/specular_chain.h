// What mirrors and glass show: a ray that is followed over them to the surfaces that send light back along
// it.
#pragma once

#include <span>
#include <vector>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/mirrors/specular_ray.h"
#include "gi_module/shared/rays/followed_scene.h"

namespace lanthorn::gi {

// Whose surface a way ends on, where it ends on one.
struct ChainSurface {
    std::uint32_t instance = 0;   // into FrameScene::instances
    std::uint32_t primitive = 0;  // triangle of the instance's mesh
    vec2 barycentric{0};          // weights of its second and third vertex
    bool front = false;
};
struct ChainEnd {
    SpecularHit hit;
    ChainSurface surface;
};

// Follows a ray over smooth metal (0.5 and more metallic, roughness below 0.5) and through transmitting
// surfaces, for at most 16 surfaces. Absorption in volumes by Beer's law. What the surface of the pixel
// itself reflects is left out; where other glass reflects as much as 0.004 of what the ray brings its
// reflection is followed too, up to four times. Appends where the ways end, that of the ray first: at least
// one.
void follow_chain(const FollowedScene& scene, const SpecularRay& ray, std::vector<ChainEnd>& ends);

// The same for many. One end a ray, in their order, then those that are found by `next`; `surfaces`:
// likewise, where they are wanted. The same with any number of threads.
std::vector<SpecularHit> follow_chains(const FollowedScene& scene, std::span<const SpecularRay> rays,
                                       reference::TileWorkers& workers,
                                       std::vector<ChainSurface>* surfaces = nullptr);

}  // namespace lanthorn::gi
