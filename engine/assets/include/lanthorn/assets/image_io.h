// Reading and writing float images: EXR, HDR, PNG; JPEG and WebP are read too.
#pragma once

#include <filesystem>

#include "lanthorn/core/image.h"

namespace lanthorn {

// Reads OpenEXR, Radiance HDR, PNG, JPEG or WebP, recognised by content. PNG, JPEG and WebP become 0..1 as
// stored: a PNG stays display-encoded, and keeps its 16 bits and its grey; JPEG and WebP have three channels,
// four where there is transparency. The whole numbers of an EXR stay what they are. Alpha is not multiplied
// in. At most kMaxDecodedTexels pixels; memory is taken for what so many bytes can hold, as decode_image()
// does it, not for what the header states. Throws InputError, also where a part of the image is missing.
ImageF read_image(const std::filesystem::path& path);

// Writes by the file's ending: .exr (32-bit float, lossless ZIP), .hdr (RGBE, 3 channels) or .png (8 bits;
// the pixels are display-encoded 0..1 already, clamped and rounded here, NaN becomes 0). The file appears
// whole or not at all, the same bytes for the same image. Throws InputError for another ending, a channel
// count that the format has not, or an unwritable path.
void write_image(const std::filesystem::path& path, const ImageF& image);

// Throws InputError unless write_image() could write to `path` now: known ending, existing folder,
// permission.
void check_image_writable(const std::filesystem::path& path);

}  // namespace lanthorn
