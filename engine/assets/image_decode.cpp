#include "lanthorn/assets/image_decode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "lanthorn/assets/png_decode.h"

namespace lanthorn {

namespace {

struct Signature {
    std::string_view bytes;
    std::size_t offset;
    const char* file_name;  // tells OpenImageIO the reader
};

using namespace std::string_view_literals;
constexpr const char* kPngName = "image.png";
constexpr std::array<Signature, 3> kSignatures = {
    {{"\x89PNG\r\n\x1a\n"sv, 0, kPngName}, {"\xff\xd8\xff"sv, 0, "image.jpg"}, {"WEBP"sv, 8, "image.webp"}}};

bool is_ktx2(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view signature = "\xABKTX 20\xBB\r\n\x1A\n"sv;
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).starts_with(signature);
}

const char* name_for(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const Signature& signature : kSignatures) {
        if (text.size() >= signature.offset && text.substr(signature.offset).starts_with(signature.bytes)) {
            return signature.file_name;
        }
    }
    return nullptr;
}

// The first line of OpenImageIO's complaint.
std::string complaint(std::string text) {
    text.erase(std::min(text.find_first_of("\r\n"), text.size()));
    return text.empty() ? "cannot be decoded" : "cannot be decoded: " + text;
}

// 1 to 4 interleaved channels to RGBA.
std::vector<std::uint8_t> to_rgba(const std::vector<std::uint8_t>& source, std::size_t texels,
                                  std::size_t channels) {
    std::vector<std::uint8_t> rgba(texels * 4);
    const bool grey = channels < 3;
    for (std::size_t i = 0; i < texels; ++i) {
        const std::uint8_t* from = &source[i * channels];
        std::uint8_t* to = &rgba[i * 4];
        to[0] = from[0];
        to[1] = grey ? from[0] : from[1];
        to[2] = grey ? from[0] : from[2];
        to[3] = channels == 2 ? from[1] : channels >= 4 ? from[3] : 255;
    }
    return rgba;
}

// Box-filtered to at most kMaxTextureSize a side.
void scale_down(Image& image) {
    const std::uint32_t width = std::min(image.width, kMaxTextureSize);
    const std::uint32_t height = std::min(image.height, kMaxTextureSize);
    std::vector<std::uint8_t> rgba(std::size_t{width} * height * 4);
    for (std::uint64_t y = 0; y < height; ++y) {
        const std::uint64_t y0 = y * image.height / height;
        const std::uint64_t y1 = std::max(y0 + 1, (y + 1) * image.height / height);
        for (std::uint64_t x = 0; x < width; ++x) {
            const std::uint64_t x0 = x * image.width / width;
            const std::uint64_t x1 = std::max(x0 + 1, (x + 1) * image.width / width);
            std::array<std::uint64_t, 4> sum{};
            for (std::uint64_t v = y0; v < y1; ++v) {
                for (std::uint64_t u = x0; u < x1; ++u) {
                    for (std::size_t c = 0; c < 4; ++c) {
                        sum[c] += image.rgba[(v * image.width + u) * 4 + c];
                    }
                }
            }
            const std::uint64_t count = (y1 - y0) * (x1 - x0);
            for (std::size_t c = 0; c < 4; ++c) {
                rgba[(y * width + x) * 4 + c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
            }
        }
    }
    image.width = width;
    image.height = height;
    image.rgba = std::move(rgba);
}

using MemoryReader = OIIO::Filesystem::IOMemReader;

MemoryReader reader_of(std::span<const std::uint8_t> bytes) {
    return {const_cast<std::uint8_t*>(bytes.data()), bytes.size()};
}

// Its header read. `reader` must live as long.
std::unique_ptr<OIIO::ImageInput> open_with_openimageio(const char* name, MemoryReader& reader) {
    OIIO::Filesystem::IOProxy* proxy = &reader;
    OIIO::ImageSpec config;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR,
                     &proxy);  // opening with a config forgets set_ioproxy()
    config.attribute("oiio:UnassociatedAlpha", 1);
    return OIIO::ImageInput::open(name, &config, proxy);
}

DecodedImage decode_with_openimageio(const char* name, std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    MemoryReader reader = reader_of(bytes);
    const auto input = open_with_openimageio(name, reader);
    if (!input) {
        result.problem = complaint(OIIO::geterror());
        return result;
    }
    const OIIO::ImageSpec spec = input->spec();
    const auto width = static_cast<std::uint64_t>(std::max(spec.width, 0));
    const auto height = static_cast<std::uint64_t>(std::max(spec.height, 0));
    if (width * height == 0 || width * height > kMaxDecodedTexels || spec.nchannels < 1) {
        result.problem =
            fmt::format("has {} x {} texels, expected 1 to {}", width, height, kMaxDecodedTexels);
        return result;
    }
    const auto channels = static_cast<std::size_t>(std::min(spec.nchannels, 4));
    std::vector<std::uint8_t> texels(width * height * channels);
    if (!input->read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::UINT8, texels.data())) {
        result.problem = complaint(input->geterror());
        return result;
    }
    result.image.width = static_cast<std::uint32_t>(width);
    result.image.height = static_cast<std::uint32_t>(height);
    result.image.rgba = to_rgba(texels, width * height, channels);
    return result;
}

}  // namespace

std::uint64_t stated_texels(std::span<const std::uint8_t> bytes) {
    const char* name = name_for(bytes);
    if (name == nullptr || std::string_view(name) == kPngName) {
        return name == nullptr ? 0 : stated_png_texels(bytes);
    }
    MemoryReader reader = reader_of(bytes);
    const auto input = open_with_openimageio(name, reader);
    if (!input) {
        OIIO::geterror();  // else it is printed when the program ends
        return 0;
    }
    const OIIO::ImageSpec& spec = input->spec();
    return static_cast<std::uint64_t>(std::max(spec.width, 0)) *
           static_cast<std::uint64_t>(std::max(spec.height, 0));
}

DecodedImage decode_image(std::span<const std::uint8_t> bytes) {
    DecodedImage result;
    const char* name = name_for(bytes);
    if (name == nullptr) {
        result.problem = is_ktx2(bytes)
                             ? "is KTX2, which is not read ('gltf-transform ktxdecompress IN OUT' writes PNG)"
                             : "is no PNG, JPEG or WebP image";
        return result;
    }
    result = std::string_view(name) == kPngName ? decode_png(bytes) : decode_with_openimageio(name, bytes);
    const std::uint32_t width = result.image.width, height = result.image.height;
    if (width > kMaxTextureSize || height > kMaxTextureSize) {
        scale_down(result.image);
        result.note = fmt::format("{} x {} texels are more than {} a side; scaled down to {} x {}", width,
                                  height, kMaxTextureSize, result.image.width, result.image.height);
    }
    return result;
}

}  // namespace lanthorn
