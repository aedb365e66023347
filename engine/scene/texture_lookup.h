// Texture look-ups on the CPU as OpenGL makes them, at full resolution (samples average, not mip maps).
#pragma once

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// The texel value at `uv` through the texture's sampler, RGBA 0..1; `srgb`: colours are decoded before they
// are interpolated. An image without pixels is white.
vec4 sample_texture(const SceneAssets& assets, const Texture& texture, vec2 uv, bool srgb);

}  // namespace lanthorn
