#include "lanthorn/assets/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <system_error>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadataPrefix = "lanthorn:";

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

std::string first_line(std::string text) {
    text.erase(std::min(text.find_first_of("\r\n"), text.size()));
    return text.empty() ? "unknown reason" : text;
}

std::vector<std::uint8_t> to_bytes(const std::vector<float>& pixels) {
    std::vector<std::uint8_t> bytes(pixels.size());
    std::transform(pixels.begin(), pixels.end(), bytes.begin(), [](float value) {
        const float limited = value > 0 ? std::min(value, 1.0f) : 0.0f;  // NaN becomes 0
        return static_cast<std::uint8_t>(std::lround(limited * 255));
    });
    return bytes;
}

}  // namespace

ImageF read_image(const fs::path& path) {
    const std::string name = path.string();
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        throw InputError(name, "", "found no such file, expected an image");
    }
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(name, &config);
    if (!input) {
        throw InputError(name, "", "cannot be read as an image: " + first_line(OIIO::geterror()));
    }
    const OIIO::ImageSpec spec = input->spec();
    ImageF image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = std::min(spec.nchannels, 4);
    if (image.width < 1 || image.height < 1 || image.channels < 1) {
        throw InputError(name, "",
                         fmt::format("found {} x {} pixels, expected at least one", spec.width, spec.height));
    }
    image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                        static_cast<std::size_t>(image.channels));
    if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
        throw InputError(name, "", "cannot be read to its end: " + first_line(input->geterror()));
    }
    const std::string prefix = kMetadataPrefix;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string key = attribute.name().string();
        if (key.starts_with(prefix)) {
            image.metadata[key.substr(prefix.size())] = attribute.get_string();
        }
    }
    return image;
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
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) {
        throw InputError(name, "", "cannot be written: " + first_line(OIIO::geterror()));
    }
    const bool bytes = format == Format::png;
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == Format::exr) {
        spec.attribute("compression", "zip");
    } else if (bytes) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    }
    for (const auto& [key, value] : image.metadata) {
        spec.attribute(kMetadataPrefix + key, value);
    }
    const std::vector<std::uint8_t> encoded = bytes ? to_bytes(image.pixels) : std::vector<std::uint8_t>();
    // Into memory first: OpenImageIO's own files do not tell of a disk that is full when they are closed.
    std::vector<unsigned char> whole;
    OIIO::Filesystem::IOVecOutput memory(whole);
    const bool made = output->set_ioproxy(&memory) && output->open(name, spec) &&
                      output->write_image(spec.format, bytes ? static_cast<const void*>(encoded.data())
                                                             : image.pixels.data()) &&
                      output->close();
    if (!made) {
        throw InputError(name, "", "cannot be written: " + first_line(output->geterror()));
    }
    write_file(path, {reinterpret_cast<const char*>(whole.data()), whole.size()});
}

void check_image_writable(const fs::path& path) {
    format_of(path);
    check_writable(path);
}

}  // namespace lanthorn
