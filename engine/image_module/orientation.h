// Pictures that lie on their side in the file.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lanthorn {

// 1 to 8, as TIFF has it: 1 is upright, 5 to 8 exchange rows and columns. Of the line of a Radiance file that
// says in which order its pixels come ("-Y 480 +X 640").
int radiance_orientation(std::span<const std::uint8_t> bytes);

// The picture upright; width and height are those of the file, and become those of the result.
std::vector<float> turned_upright(std::vector<float> pixels, int& width, int& height, int channels,
                                  int orientation);

}  // namespace lanthorn
