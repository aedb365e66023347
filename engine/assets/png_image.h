// PNG files of display-encoded values.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lanthorn/core/image.h"

namespace lanthorn {

// 0 to 1 as stored, of 8 or 16 bits (palettes and smaller depths become 8), with the channels of the file; a
// colour that is keyed out becomes alpha. Throws InputError(NAME).
ImageF read_png(const std::string& name, std::span<const std::uint8_t> bytes);

// 8 bits, sRGB, metadata as text: values are clamped to 0..1 and rounded, NaN becomes 0.
// png_bytes() writes textures; this is for people, and compressed.
std::string png_picture(const ImageF& image);

}  // namespace lanthorn
