// Encoded images to texels: PNG, JPEG and WebP here, others by OpenImageIO.
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
    std::string damage;   // why a part of it was not there and is grey, one line; usually empty
    std::string note;     // what was mended or done to it (damage, scaled down), one line; usually empty
};

// Why an image of that size is not decoded, one line; empty if it is.
std::string problem_of_size(std::uint64_t width, std::uint64_t height);

// That so many texels cannot be in so few bytes.
std::string problem_of_too_few_bytes(std::uint64_t width, std::uint64_t height, std::size_t bytes);

// For formats that pack what is of one colour without bound, so that no size is impossible: why so many
// texels are not taken from so few bytes, one line; empty if they are. Up to 4096 x 4096 they are, beyond it
// `most_a_byte`: more than files of pictures come to, flat ones too.
std::string problem_of_packing(std::uint64_t width, std::uint64_t height, std::size_t bytes,
                               std::uint64_t most_a_byte);
inline constexpr std::uint64_t kMostTexelsAByte =
    4096 * 8;  // WebP's longest copy of one colour, for each bit

// Texels that the image's header says it has; 0 where it cannot be read or is not believed. Nothing is
// decoded. Thread-safe.
std::uint64_t stated_texels(std::span<const std::uint8_t> bytes);

// Whether the first bytes are those of PNG, JPEG or WebP, which are decoded here.
bool is_decoded(std::span<const std::uint8_t> bytes);

// Decodes by content, whatever the name says. Grey becomes RGB, absent alpha 1; 16-bit channels become 8-bit;
// alpha stays unassociated. Larger than kMaxTextureSize a side: scaled down by box filter. Memory is taken
// for what so many bytes can hold: of files that pack without bound (WebP, JPEG in arithmetic codes) for up
// to 4096 x 4096 texels whatever the header states, beyond it for kMostTexelsAByte. Thread-safe; throws
// nothing but std::bad_alloc.
DecodedImage decode_image(std::span<const std::uint8_t> bytes);

// As it is stored: of any size, `damage` in place of a note.
DecodedImage decode_unscaled(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
