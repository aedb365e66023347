#include "tools/lanthorn/common/image_size.h"

#include <fmt/format.h>

#include <cstdio>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

ivec2 parse_size(const std::string& text) {
    constexpr int kLargest = 16384;
    int width = 0, height = 0, read = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &read) != 2 ||
        static_cast<std::size_t>(read) != text.size() || width < 1 || height < 1 || width > kLargest ||
        height > kLargest) {
        throw InputError(fmt::format("--size: found '{}', expected WIDTHxHEIGHT from 1x1 to {}x{}", text,
                                     kLargest, kLargest));
    }
    return {width, height};
}

}  // namespace lanthorn::tools
