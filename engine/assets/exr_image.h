// OpenEXR files.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "lanthorn/core/image.h"

namespace lanthorn {

// The file if it is a plain one, as exr_bytes() makes them and most programs do: one part of scan lines, its
// data window the display window, every channel of its size, any compression. Nothing if it is another, which
// the image module reads. Channels as chosen_channels() has them. Alpha stays as it is stored. Texts of the
// header become metadata where write_image() wrote them. Memory is taken as pixels are read, not for what the
// header states alone. Throws InputError(NAME): damaged, cut off, more than kMaxDecodedTexels pixels, rows
// above 1 MiB.
std::optional<ImageF> read_plain_exr(const std::string& name, std::span<const std::uint8_t> bytes);

// 32-bit float, lossless ZIP, the same bytes for the same image. Channels: Y; R and G; RGB; RGBA.
std::string exr_bytes(const ImageF& image);

}  // namespace lanthorn
