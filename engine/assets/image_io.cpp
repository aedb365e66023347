#include "lanthorn/assets/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/assets/exr_image.h"
#include "engine/assets/gltf_file.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/image_format.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/image_module_file.h"
#include "engine/assets/module_image.h"
#include "engine/assets/png_image.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace {

namespace fs = std::filesystem;

// In small letters.
std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool is_written_directly(std::string_view ending) {
    return ending == ".exr" || ending == ".png";
}

std::string known_ending(const fs::path& path) {
    std::string ending = ending_of(path);
    if (!is_written_directly(ending) && format_to_write(ending).format.empty()) {
        throw InputError(
            path.string(), "",
            fmt::format("found ending '{}', expected .exr, .png, .hdr, .tif, .jpg, .webp or another that "
                        "OpenImageIO writes",
                        printable(shortened(ending, 40))));
    }
    return ending;
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

std::string encoded(const std::string& name, const std::string& ending, const ImageF& image) {
    if (ending == ".exr") {
        return exr_bytes(image);
    }
    if (ending == ".png") {
        return png_picture(image);
    }
    const WrittenFormat written = format_to_write(ending);
    return bytes_by_module(name, image, written.format, written.linear);
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
    if (begins_with(bytes, "\x89PNG\r\n\x1a\n"sv)) {
        return read_png(name, bytes);
    }
    if (is_decoded(bytes)) {
        return read_texels(name, bytes);
    }
    const std::string_view format = format_to_read(bytes, ending_of(path));
    if (format == "openexr") {
        if (std::optional<ImageF> plain = read_plain_exr(name, bytes)) {
            return std::move(*plain);
        }
    }
    if (format.empty()) {
        throw InputError(name, "",
                         "cannot be read as an image: expected EXR, HDR, PNG, JPEG, WebP, TIFF or another "
                         "format that OpenImageIO reads");
    }
    return read_by_module(name, bytes, format);
}

void write_image(const fs::path& path, const ImageF& image) {
    assert(image.pixels.size() == static_cast<std::size_t>(image.width) *
                                      static_cast<std::size_t>(image.height) *
                                      static_cast<std::size_t>(image.channels));
    const std::string name = path.string();
    const std::string ending = known_ending(path);
    if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 ||
        (format_to_write(ending).format == "hdr" && image.channels != 3)) {
        throw InputError(name, "",
                         fmt::format("cannot hold an image of {} x {} pixels and {} channels", image.width,
                                     image.height, image.channels));
    }
    std::string whole;
    try {
        whole = encoded(name, ending, image);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(name, "", "cannot be written: " + first_line(error.what()));
    }
    write_file(path, whole);
}

void check_image_writable(const fs::path& path) {
    const std::string ending = known_ending(path);
    check_writable(path);
    std::string problem;
    if (!is_written_directly(ending) && image_module(problem) == nullptr) {
        throw InputError(path.string(), "", problem);
    }
}

bool holds_linear(const fs::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".exr" || format_to_write(ending).linear;
}

}  // namespace lanthorn
