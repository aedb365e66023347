#include "lanthorn/assets/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "engine/assets/exr_image.h"
#include "engine/assets/gltf_file.h"
#include "engine/assets/hdr_image.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/png_image.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

namespace fs = std::filesystem;

enum class Format { exr, hdr, png };

Format format_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".exr") {
        return Format::exr;
    }
    if (ending == ".hdr") {
        return Format::hdr;
    }
    if (ending == ".png") {
        return Format::png;
    }
    throw InputError(path.string(), "",
                     fmt::format("found ending '{}', expected .exr, .png or .hdr", ending));
}

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view signature) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).starts_with(signature);
}

// JPEG and WebP.
ImageF read_texels(const std::string& name, std::span<const std::uint8_t> bytes) {
    const DecodedImage decoded = decode_unscaled(bytes);
    if (!decoded.problem.empty()) {
        throw InputError(name, "", decoded.problem);
    }
    if (!decoded.damage.empty()) {  // whole, or not at all
        throw InputError(name, "", "cannot be read to its end: " + decoded.damage);
    }
    const std::vector<std::uint8_t>& rgba = decoded.image.rgba;
    ImageF image;
    image.width = static_cast<int>(decoded.image.width);
    image.height = static_cast<int>(decoded.image.height);
    image.channels = 3;
    for (std::size_t at = 3; at < rgba.size() && image.channels == 3; at += 4) {
        image.channels = rgba[at] == 255 ? 3 : 4;
    }
    const auto channels = static_cast<std::size_t>(image.channels);
    image.pixels.reserve(rgba.size() / 4 * channels);
    for (std::size_t at = 0; at < rgba.size(); at += 4) {
        for (std::size_t c = 0; c < channels; ++c) {
            image.pixels.push_back(static_cast<float>(rgba[at + c]) * (1.0f / 255));
        }
    }
    return image;
}

std::string encoded(Format format, const ImageF& image) {
    switch (format) {
        case Format::exr:
            return exr_bytes(image);
        case Format::hdr:
            return hdr_bytes(image);
        default:
            return png_picture(image);
    }
}

}  // namespace

ImageF read_image(const fs::path& path) {
    using namespace std::string_view_literals;
    const std::string name = path.string();
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        throw InputError(name, "", "found no such file, expected an image");
    }
    const std::vector<std::uint8_t> bytes = read_bytes(path, name, "");
    if (begins_with(bytes, "\x76\x2f\x31\x01"sv)) {
        return read_exr(name, bytes);
    }
    if (begins_with(bytes, "#?")) {
        return read_hdr(name, bytes);
    }
    if (begins_with(bytes, "\x89PNG\r\n\x1a\n"sv)) {
        return read_png(name, bytes);
    }
    if (!is_decoded(bytes)) {
        throw InputError(name, "", "cannot be read as an image: expected EXR, HDR, PNG, JPEG or WebP");
    }
    return read_texels(name, bytes);
}

void write_image(const fs::path& path, const ImageF& image) {
    assert(image.pixels.size() == static_cast<std::size_t>(image.width) *
                                      static_cast<std::size_t>(image.height) *
                                      static_cast<std::size_t>(image.channels));
    const std::string name = path.string();
    const Format format = format_of(path);
    if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 ||
        (format == Format::hdr && image.channels != 3)) {
        throw InputError(name, "",
                         fmt::format("cannot hold an image of {} x {} pixels and {} channels", image.width,
                                     image.height, image.channels));
    }
    std::string whole;
    try {
        whole = encoded(format, image);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(name, "", "cannot be written: " + first_line(error.what()));
    }
    write_file(path, whole);
}

void check_image_writable(const fs::path& path) {
    format_of(path);
    check_writable(path);
}

}  // namespace lanthorn
