// OpenEXR files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lanthorn/core/image.h"

namespace lanthorn {

// The first part of `bytes`: its data window, scan lines or tiles, any compression. Channels, at most four:
// R, G, B and A where there are R, G and B, else those of the first layer by name, A last. Alpha stays as it
// is stored. Texts of the header become metadata where write_image() wrote them. Memory is taken as pixels
// are read, not for what the header states alone. Throws InputError(NAME): damaged, cut off, deep,
// subsampled, more than kMaxDecodedTexels pixels, rows above 1 MiB.
ImageF read_exr(const std::string& name, std::span<const std::uint8_t> bytes);

// 32-bit float, lossless ZIP, the same bytes for the same image. Channels: Y; R and G; RGB; RGBA.
std::string exr_bytes(const ImageF& image);

}  // namespace lanthorn
