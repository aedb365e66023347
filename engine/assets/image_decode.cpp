#include "engine/assets/image_decode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/assets/image_format.h"
#include "engine/assets/image_metadata.h"
#include "engine/assets/jpeg_decode.h"
#include "engine/assets/module_image.h"
#include "engine/assets/png_decode.h"
#include "engine/assets/webp_decode.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kSurelyFine = 1u << 24;  // texels: 64 MiB

struct Format {
    std::string_view signature;
    std::size_t offset;
    DecodedImage (*decode)(Bytes);
    std::uint64_t (*stated_texels)(Bytes);
};

using namespace std::string_view_literals;
constexpr std::array<Format, 3> kFormats = {{{"\x89PNG\r\n\x1a\n"sv, 0, decode_png, stated_png_texels},
                                             {"\xff\xd8\xff"sv, 0, decode_jpeg, stated_jpeg_texels},
                                             {"WEBP"sv, 8, decode_webp, stated_webp_texels}}};

bool has_at(Bytes bytes, std::size_t offset, std::string_view signature) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.size() >= offset && text.substr(offset).starts_with(signature);
}

const Format* format_of(Bytes bytes) {
    const auto found = std::ranges::find_if(
        kFormats, [&](const Format& format) { return has_at(bytes, format.offset, format.signature); });
    return found != kFormats.end() ? &*found : nullptr;
}

// Texels of a format that OpenImageIO reads, display-encoded in 8 bits.
DecodedImage decode_by_module(Bytes bytes, std::string_view format) {
    DecodedImage result;
    try {
        const ImageF image = read_by_module("", bytes, format);
        const bool grey = image.channels < 3;
        const int alpha = image.channels % 2 == 0 ? image.channels - 1 : -1;
        result.image.width = static_cast<std::uint32_t>(image.width);
        result.image.height = static_cast<std::uint32_t>(image.height);
        result.image.rgba.reserve(std::size_t{4} * result.image.width * result.image.height);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                for (int c = 0; c < 3; ++c) {
                    const float value = image.at(x, y, grey ? 0 : c);
                    result.image.rgba.push_back(byte_of(image.linear ? srgb_from_linear(value) : value));
                }
                result.image.rgba.push_back(alpha >= 0 ? byte_of(image.at(x, y, alpha)) : 255);
            }
        }
    } catch (const InputError& error) {
        const std::string_view line = error.what();
        result.problem = line.substr(line.starts_with(": ") ? 2 : 0);
    }
    return result;
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

}  // namespace

std::string problem_of_size(std::uint64_t width, std::uint64_t height) {
    if (width > 0 && height > 0 && width <= kMaxDecodedTexels / height) {
        return {};
    }
    return fmt::format("has {} x {} texels, expected 1 to {}", width, height, kMaxDecodedTexels);
}

std::string problem_of_too_few_bytes(std::uint64_t width, std::uint64_t height, std::size_t bytes) {
    return fmt::format("has {} x {} texels in {} bytes: it is cut off", width, height, bytes);
}

std::string problem_of_packing(std::uint64_t width, std::uint64_t height, std::size_t bytes,
                               std::uint64_t most_a_byte) {
    if (width * height <= kSurelyFine || (width * height - kSurelyFine) / most_a_byte <= bytes) {
        return {};
    }
    return fmt::format("has {} x {} texels in {} bytes, more than are taken from so few", width, height,
                       bytes);
}

bool is_decoded(Bytes bytes) {
    return format_of(bytes) != nullptr;
}

std::uint64_t stated_texels(Bytes bytes) {
    const Format* format = format_of(bytes);
    if (format != nullptr) {
        return format->stated_texels(bytes);
    }
    const std::string_view other = format_to_read(bytes, "");
    return other.empty() ? 0 : size_by_module(bytes, other);
}

DecodedImage decode_unscaled(Bytes bytes) {
    DecodedImage result;
    const Format* format = format_of(bytes);
    if (const std::string_view other = format_to_read(bytes, ""); format == nullptr && !other.empty()) {
        return decode_by_module(bytes, other);
    }
    if (format == nullptr) {
        result.problem = has_at(bytes, 0, "\xABKTX 20\xBB\r\n\x1A\n"sv)
                             ? "is KTX2, which is not read ('gltf-transform ktxdecompress IN OUT' writes PNG)"
                             : "is of no image format that is known";
        return result;
    }
    return format->decode(bytes);
}

DecodedImage decode_image(Bytes bytes) {
    DecodedImage result = decode_unscaled(bytes);
    if (!result.damage.empty()) {
        result.note = fmt::format("the image is damaged ({}); what is missing is grey", result.damage);
    }
    const std::uint32_t width = result.image.width, height = result.image.height;
    if (width > kMaxTextureSize || height > kMaxTextureSize) {
        scale_down(result.image);
        result.note += fmt::format("{}{} x {} texels are more than {} a side; scaled down to {} x {}",
                                   result.note.empty() ? "" : "; ", width, height, kMaxTextureSize,
                                   result.image.width, result.image.height);
    }
    return result;
}

}  // namespace lanthorn
