// Skies from image files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/scene/scene_data.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

// An equirectangular image as a sky: 1 in the file is 1 nit; display-encoded ones (ImageF::linear) are
// decoded to 0..1. The suns in it are taken out of Sky::light and returned in `suns`. Pixels that are
// negative or not finite become as those around them; `note` says so in one line. Throws InputError, one
// line, for what cannot be read, is not about twice as wide as high, or is larger than 8192 x 4096.
// O(pixels).
Sky read_sky(const std::filesystem::path& path, std::vector<SkySun>& suns, std::string* note = nullptr);

// The image as a sky, with its suns taken out of Sky::light and returned in `suns`. O(pixels).
Sky sky_without_suns(SkyImage image, std::vector<SkySun>& suns);

// Adds `node` with that sky, and below it a node with a directional light for each sun, as bright as the
// sky's intensity says.
void add_sky_nodes(SceneData& scene, NodeData node, Sky sky, const std::vector<SkySun>& suns);

}  // namespace lanthorn
