// WebP files to texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/assets/image_decode.h"

namespace lanthorn {

// As decode_image(), which uses it. Lossy and lossless; of an animation the first picture, as
// EXT_texture_webp asks.
DecodedImage decode_webp(std::span<const std::uint8_t> bytes);

// As stated_texels(), which uses it.
std::uint64_t stated_webp_texels(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
