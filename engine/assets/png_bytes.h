#pragma once

#include <cstdint>
#include <string>

#include "lanthorn/scene/material.h"

namespace lanthorn {

// `image` as a PNG file, 8 bits a channel, RGB where every texel is opaque, in stored (uncompressed) deflate
// blocks: the same bytes on every machine, whatever its zlib. PNG specification, second edition; RFC 1950,
// 1951.
std::string png_bytes(const Image& image);

}  // namespace lanthorn
