// Image files of every kind that is read, made by the formats' own libraries.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lanthorn {

// Channels of `texels` are interleaved, rows from the top.

// A PNG: grey, grey and alpha, RGB or RGBA.
std::string make_png(int width, int height, const std::vector<std::uint8_t>& texels, int channels);
std::string make_png16(int width, int height, const std::vector<std::uint16_t>& texels, int channels);
// One of `bits` (1, 2, 4 or 8) an index; `colours` are RGB, `alphas` of the first of them.
std::string make_palette_png(int width, int height, const std::vector<std::uint8_t>& indices, int bits,
                             const std::vector<std::uint8_t>& colours,
                             const std::vector<std::uint8_t>& alphas);

// Lossless, three or four channels.
std::string make_webp(int width, int height, const std::vector<std::uint8_t>& texels, int channels = 3);
// One after the other, each of four channels.
std::string make_animated_webp(int width, int height, const std::vector<std::vector<std::uint8_t>>& frames);

enum class JpegKind { baseline, progressive, cmyk, adobe_cmyk };
// Of the best quality, without subsampling; one or three channels, four of CMYK, as they are stored.
std::string make_jpeg(int width, int height, const std::vector<std::uint8_t>& texels, int channels,
                      JpegKind kind = JpegKind::baseline);

enum class ExrKind { lines, tiles, whole_numbers };
// An EXR with the channels of `names`, of 16 bits, whole numbers of 32; its window begins at (-3, 5).
std::string make_exr(int width, int height, const std::vector<float>& values,
                     const std::vector<std::string>& names, ExrKind kind = ExrKind::lines);

}  // namespace lanthorn
