// Reading and writing float images: PNG, JPEG, WebP and plain EXR directly, all else by OpenImageIO.
#pragma once

#include <cstddef>
#include <filesystem>

#include "lanthorn/core/image.h"

namespace lanthorn {

// Reads an image, recognised by content: PNG, JPEG, WebP, OpenEXR, and what OpenImageIO knows: Radiance HDR,
// TIFF, TX, TGA, BMP, DDS, PSD, DPX and more (docs/images.md). The first picture of a file of several, its
// largest level.
//   whole numbers     0..1 as stored: a PNG stays display-encoded, and keeps its 16 bits and its grey; those
//   of an
//                     EXR stay what they are; ImageF::linear says which
//   channels          R, G, B and A where there are R, G and B, else the first layer's; at most four. JPEG
//   and WebP
//                     have three, four where there is transparency
//   alpha             not multiplied in: a TIFF that says it is, is divided by it; of EXR as it is stored
//   windows of EXR    the display window; black, and clear, outside of the data window
//   orientation       turned upright
//   EXPOSURE of HDR   taken out: values are radiance
//   primaries         of HDR and EXR, where stated: BT.709's
// At most kMaxDecodedTexels pixels and 256 channels; memory is taken for what so many bytes can hold, as
// decode_image() does it, not for what the header states. What OpenImageIO reads is read in a copy of the
// process, so that a damaged file costs no more than the copy. Throws InputError, one line, also where a part
// of the image is missing, or where the image module is not installed (it names the package).
ImageF read_image(const std::filesystem::path& path);

// Replaces values that are infinite or no numbers, and negative ones unless `negative`, each by the middle
// one of the sound values of its channel in the eight pixels around; 0 where there are none. `round`: rows
// end where they begin, as a sky's. Returns how many pixels had such. O(pixels).
std::size_t repair_pixels(ImageF& image, bool negative, bool round = false);

// Writes by the file's ending: .exr (32-bit float, lossless ZIP), .png (8 bits), and by OpenImageIO .hdr
// (RGBE, 3 channels), .tif (32-bit float), .jpg, .webp, .tga, .bmp, .dpx and others. Where holds_linear() is
// false pixels are display-encoded 0..1 already, clamped and rounded here, NaN becomes 0. The file appears
// whole or not at all, the same bytes for the same image. Throws InputError for another ending, a channel
// count that the format has not, an unwritable path, or where the image module is not installed.
void write_image(const std::filesystem::path& path, const ImageF& image);

// Throws InputError unless write_image() could write to `path` now: known ending, existing folder,
// permission, the image module where it is needed.
void check_image_writable(const std::filesystem::path& path);

// Whether files of that ending hold linear values of any size (.exr, .hdr, .tif) rather than display-encoded
// ones.
bool holds_linear(const std::filesystem::path& path);

}  // namespace lanthorn
