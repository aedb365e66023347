// JPEG files to texels.
#pragma once

#include <cstdint>
#include <span>

#include "engine/assets/image_decode.h"

namespace lanthorn {

// As decode_image(), which uses it. Baseline and progressive, grey, RGB, YCbCr, and CMYK and YCCK as Adobe
// and others store them (converted without a colour profile). Colour profiles and EXIF, its orientation too,
// are ignored, as glTF 2.0, 3.8.3, asks. Of a file that is cut off or damaged what is there is read, with a
// note, as other readers do. More than 1000 scans are taken for an attack on time.
DecodedImage decode_jpeg(std::span<const std::uint8_t> bytes);

// As stated_texels(), which uses it.
std::uint64_t stated_jpeg_texels(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
