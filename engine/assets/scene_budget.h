// What a scene may cost: no file, however it was made, lets a frame take time out of all proportion.
#pragma once

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Layers of surface, one upon the other, that a mesh, a place or the whole scene may have on average. Every
// one is drawn into every light's map and every environment map; models have a few tens at most.
inline constexpr double kMostLayers = 500;
// Triangles of all instances together.
inline constexpr std::uint64_t kMostPlacedTriangles = std::uint64_t{1} << 26;

// Cuts `scene` to that, in the order of the file: triangles of a mesh whose area is more than kMostLayers
// times its box's, then instances that stand in the same place, then those that are more than the whole scene
// may have. Says in the warnings what was left out. O(triangles + instances).
void cut_to_budget(SceneData& scene);

}  // namespace lanthorn
