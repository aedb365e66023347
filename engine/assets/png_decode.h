// PNG files to texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/assets/image_decode.h"

namespace lanthorn {

// As decode_image(), which uses it: images up to kMaxDecodedTexels, of their own size. Memory is taken for
// what the file can hold. Colour spaces in the file are ignored, as glTF 2.0, 3.8.3, asks.
DecodedImage decode_png(std::span<const std::uint8_t> bytes);

// As stated_texels(), which uses it.
std::uint64_t stated_png_texels(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
