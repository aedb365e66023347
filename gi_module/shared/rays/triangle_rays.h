// TriangleSight on Embree.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/rays/followed_scene.h"
#include "gi_module/shared/rays/seen_triangles.h"

namespace lanthorn::gi {

// TriangleSight::see.
std::vector<std::vector<SeenTriangle>> see_triangles(const FollowedScene& scene,
                                                     std::span<const CubeFace> faces,
                                                     std::span<const std::uint8_t> stands,
                                                     reference::TileWorkers& workers);

}  // namespace lanthorn::gi
