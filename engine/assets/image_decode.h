// Encoded images (PNG, JPEG, ...) to texels.
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
    std::string note;     // what was done to it (scaled down), one line; usually empty
};

// Texels that the image's header says it has; 0 where it cannot be read. Nothing is decoded. Thread-safe.
std::uint64_t stated_texels(std::span<const std::uint8_t> bytes);

// Decodes by content, whatever the name says. Grey becomes RGB, absent alpha 1; 16-bit channels become 8-bit;
// alpha stays unassociated. Larger than kMaxTextureSize a side: scaled down by box filter. Thread-safe;
// throws nothing but std::bad_alloc.
DecodedImage decode_image(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
