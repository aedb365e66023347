// The sky among the lit texels: what a ray that meets nothing has met. Its places follow those of the maps,
// one for each cell of an octahedral map of the directions (Meyer et al. 2010), so that light of the sky is
// shaded and changed like any other. The GLSL side: sky_places.glsl.
#pragma once

#include <optional>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

inline constexpr int kSkySide = 32;  // cells; about 6 degrees each
inline constexpr int kSkyPlaces = kSkySide * kSkySide;

// pi times the mean radiance of each cell, in lux: what a lit texel of that radiance reflects. All of them
// together have the flux of the image. 0 without a sky. O(pixels of the image).
std::vector<vec4> sky_radiosity(const std::optional<SkyInstance>& sky);

}  // namespace lanthorn::gi
