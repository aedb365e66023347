// What both forms of `lanthorn inspect` are about: where nodes stand, and what a scene shows.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

// By node, to world space.
std::vector<dmat4> world_matrices(const SceneData& scene);

struct WorldBox {
    dvec3 lower{HUGE_VAL}, upper{-HUGE_VAL};  // metres
    bool empty() const { return !(lower.x <= upper.x); }
};
// Of all vertices as they stand in the file, undeformed.
WorldBox world_bounds(const SceneData& scene, const std::vector<dmat4>& world);

// Triangles over the nodes' meshes: one shown twice counts twice.
std::uint64_t placed_triangles(const SceneData& scene);

// "directional", "point" or "spot".
const char* light_type_name(LightType type);

// A material's textures, present or not, by name.
std::array<std::pair<const TextureRef*, const char*>, 8> named_textures(const Material& material);

}  // namespace lanthorn::tools
