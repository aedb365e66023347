// Encoded images (PNG, JPEG, WebP) to texels.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lanthorn/scene/material.h"

namespace lanthorn {

inline constexpr std::uint32_t kMaxTextureSize = 16384;       // texels a side, GL 4.5 class hardware
inline constexpr std::uint64_t kMaxDecodedTexels = 1u << 28;  // 1 GiB of RGBA: more is taken for an attack

struct DecodedImage {
    Image image;          // empty if `problem` is not
    std::string problem;  // why it cannot be decoded, one line
    std::string note;     // what was mended or done to it (scaled down), one line; usually empty
};

// Why an image of that size is not decoded, one line; empty if it is.
std::string problem_of_size(std::uint64_t width, std::uint64_t height);

// That so many texels cannot be in so few bytes.
std::string problem_of_too_few_bytes(std::uint64_t width, std::uint64_t height, std::size_t bytes);

// Texels that the image's header says it has; 0 where it cannot be read. Nothing is decoded. Thread-safe.
std::uint64_t stated_texels(std::span<const std::uint8_t> bytes);

// Whether the first bytes are those of a format that decode_image() reads.
bool is_decoded(std::span<const std::uint8_t> bytes);

// Decodes by content, whatever the name says. Grey becomes RGB, absent alpha 1; 16-bit channels become 8-bit;
// alpha stays unassociated. Larger than kMaxTextureSize a side: scaled down by box filter. Thread-safe;
// throws nothing but std::bad_alloc.
DecodedImage decode_image(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
