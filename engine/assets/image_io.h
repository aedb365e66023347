// Reading and writing float images: EXR, PNG, HDR.
#pragma once

#include <filesystem>

#include "lanthorn/core/image.h"

namespace lanthorn {

// Reads .exr, .png or .hdr (whatever OpenImageIO knows, in fact). Integer formats become 0..1 as stored: a
// PNG stays display-encoded. Alpha is not multiplied in. Throws InputError.
ImageF read_image(const std::filesystem::path& path);

// Writes by the file's ending: .exr (32-bit float, lossless ZIP), .hdr (RGBE, 3 channels) or .png (8 bits;
// the pixels are display-encoded 0..1 already, clamped and rounded here, NaN becomes 0). The file appears
// whole or not at all. Throws InputError for another ending, a channel count that the format has not, or an
// unwritable path.
void write_image(const std::filesystem::path& path, const ImageF& image);

// Throws InputError unless write_image() could write to `path` now: known ending, existing folder,
// permission.
void check_image_writable(const std::filesystem::path& path);

}  // namespace lanthorn
