#include "engine/assets/png_decode.h"

#include <fmt/format.h>

#include <vector>

#include "engine/assets/png_reader.h"

namespace lanthorn {

std::uint64_t stated_png_texels(std::span<const std::uint8_t> bytes) {
    PngReader reader(bytes);
    return reader.read_header() && reader.fits() ? reader.width * reader.height : 0;
}

DecodedImage decode_png(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    PngReader reader(bytes);
    if (!reader.read_header()) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        return result;
    }
    result.problem = problem_of_size(reader.width, reader.height);
    if (result.problem.empty() && !reader.fits()) {
        result.problem = problem_of_too_few_bytes(reader.width, reader.height, bytes.size());
    }
    if (!result.problem.empty()) {
        return result;
    }
    result.image.rgba.resize(4 * reader.width * reader.height);
    std::vector<png_bytep> rows(reader.height);
    for (std::size_t y = 0; y < rows.size(); ++y) {
        rows[y] = result.image.rgba.data() + 4 * reader.width * y;
    }
    if (!reader.expect_rgba8() || !reader.read_rows(rows.data())) {
        result.problem = fmt::format("cannot be decoded: {}", reader.message());
        result.image = {};
        return result;
    }
    result.image.width = static_cast<std::uint32_t>(reader.width);
    result.image.height = static_cast<std::uint32_t>(reader.height);
    return result;
}

}  // namespace lanthorn
