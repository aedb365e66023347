// Which of OpenImageIO's formats an image file is of: no other is asked to read it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace lanthorn {

// OpenImageIO's name of the format by the first bytes, or, for formats without a signature of their own and
// for cameras' raw files, by `ending` (".tga", in small letters); empty if none is known. Not of PNG, JPEG
// and WebP.
std::string_view format_to_read(std::span<const std::uint8_t> bytes, std::string_view ending);

struct WrittenFormat {
    std::string_view format;  // OpenImageIO's name; empty: not written
    bool linear = false;      // 32-bit floats as they are, else whole numbers of display-encoded 0..1
};

// What a file of that ending is written as; nothing for .exr and .png.
WrittenFormat format_to_write(std::string_view ending);

}  // namespace lanthorn
