// Skies from image files.
#pragma once

#include <filesystem>
#include <vector>

#include "lanthorn/scene/scene_data.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

// An equirectangular image (.hdr, .exr; a display-encoded .png is decoded to 0..1) as a sky: 1 in the file is
// 1 nit. The suns in it are taken out of Sky::light and returned in `suns`. Throws InputError, one line, for
// what cannot be read, is not about twice as wide as high, is larger than 8192 x 4096, or has pixels that
// are negative or not finite. O(pixels).
Sky read_sky(const std::filesystem::path& path, std::vector<SkySun>& suns);

// The image as a sky, with its suns taken out of Sky::light and returned in `suns`. O(pixels).
Sky sky_without_suns(SkyImage image, std::vector<SkySun>& suns);

// Adds `node` with that sky, and below it a node with a directional light for each sun, as bright as the
// sky's intensity says.
void add_sky_nodes(SceneData& scene, NodeData node, Sky sky, const std::vector<SkySun>& suns);

}  // namespace lanthorn
