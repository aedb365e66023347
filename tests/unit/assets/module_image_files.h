// Files of the formats that OpenImageIO reads, written byte by byte, and what is read from them.
#pragma once

#include <gtest/gtest.h>

#include <ImathBox.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/assets/image_io.h"
#include "tests/unit/assets/gltf_builder.h"

namespace lanthorn::module_images {

std::span<const std::uint8_t> as_bytes(const std::string& file);
// By the module. `ending`: of its name, for formats that are known by it alone.
ImageF read(const std::string& file, const std::string& ending = "");

// Values that rise from 0 to 1, again and again.
ImageF ramp(int width, int height, int channels);

// A file of Radiance: `lines` of its header, the line of its size, and its rows.
std::string radiance(const std::string& lines, const std::string& size, const std::string& rows);
// RGBE of 8 bits and a shared exponent.
std::string rgbe(const std::array<double, 3>& colour);

// Little-endian entries of a TIFF of one strip.
std::string tiff(int width, int height, int samples, const std::string& pixels,
                 const std::vector<std::pair<int, int>>& more);

// 32-bit RGB of (4, 2, 1) in a window of a picture.
std::string windowed(const Imath::Box2i& full, const Imath::Box2i& window);

// Pixels of RGBE.
const std::string kOne("\x80\x80\x80\x81", 4), kRed("\xff\x00\x00\x80", 4), kBlack(4, '\0');

constexpr float kStepsOfRgbe = 4 / 256.0f;  // of the largest value; a matrix adds up those of three

// Of the first pixel; `tolerance`: of the largest value.
void expect_pixel(const ImageF& image, const std::array<float, 3>& expected, float tolerance = kStepsOfRgbe);

class ModuleFiles : public testing::Test {
  protected:
    // The bytes of a ramp that was written.
    std::string file(const char* name, int channels, int width = 12, int height = 9) {
        write_image(folder.path() / name, ramp(width, height, channels));
        std::ifstream stream(folder.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    TemporaryFolder folder;
};

}  // namespace lanthorn::module_images
