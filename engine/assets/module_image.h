// Images of every format that OpenImageIO knows, through the image module.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lanthorn/core/image.h"

namespace lanthorn {

// Of `format` (image_format.h). What becomes of the file is told at read_image(). The reader runs in a copy
// of the process (work_apart.h). Throws InputError(NAME), one line: no module, damaged, more than
// kMaxDecodedTexels pixels or 256 channels, or more pixels than are taken from so few bytes.
ImageF read_by_module(const std::string& name, std::span<const std::uint8_t> bytes, std::string_view format);

// Pixels that the file says it has, by the same reader; 0 where it cannot be read or is not believed.
std::uint64_t size_by_module(std::span<const std::uint8_t> bytes, std::string_view format);

// The file. linear: values are written as 32-bit floats, as they are, where the format has them. Throws
// InputError(NAME).
std::string bytes_by_module(const std::string& name, const ImageF& image, std::string_view format,
                            bool linear);

}  // namespace lanthorn
