#pragma once

#include <cstdint>
#include <string>

#include "lanthorn/scene/material.h"

namespace lanthorn::scene_generator {

// `image`'s colours (alpha dropped) as a PNG file, 8 bits RGB, in stored (uncompressed) deflate blocks: the
// same bytes on every machine, whatever its zlib. PNG specification, second edition; RFC 1950, 1951.
std::string png_bytes(const Image& image);

}  // namespace lanthorn::scene_generator
