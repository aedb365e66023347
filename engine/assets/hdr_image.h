// Radiance's picture files: colours of three bytes that share an exponent.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lanthorn/core/image.h"

namespace lanthorn {

// FORMAT=32-bit_rle_rgbe (Ward 1991, "Real Pixels", Graphics Gems II), rows stored whole, in runs of pixels
// or in runs of each byte's plane, in any of the eight orders of rows and columns. A byte b with exponent e
// is b * 2^(e - 136). EXPOSURE and GAMMA are not applied, as most readers do not. Memory is taken as pixels
// are read. Throws InputError(NAME): damaged, cut off, more than kMaxDecodedTexels pixels, XYZE.
ImageF read_hdr(const std::string& name, std::span<const std::uint8_t> bytes);

// Of three channels, in runs of each plane. Values are rounded to 8 bits below the largest of the three;
// negative ones and NaN become 0, those above the format's largest (about 1.7e38) that.
std::string hdr_bytes(const ImageF& image);

}  // namespace lanthorn
