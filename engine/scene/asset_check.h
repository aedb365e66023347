// Whether an asset may come into a store: what deformation, rendering and tracing rely on.
#pragma once

#include <string>

#include "lanthorn/scene/scene_assets.h"

namespace lanthorn {

// Each: what is wrong, and what was expected, without the asset's name; empty if nothing is. O(data).
std::string problem_of(const Mesh& mesh, const SceneAssets& among);
std::string problem_of(const Material& material, const SceneAssets& among);
std::string problem_of(const Texture& texture, const SceneAssets& among);
std::string problem_of(const Image& image, const SceneAssets& among);

}  // namespace lanthorn
