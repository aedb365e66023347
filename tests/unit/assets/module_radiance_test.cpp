// Radiance's pictures as OpenImageIO reads them: exposure, primaries, XYZ, and the order of rows and columns.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/unit/assets/module_image_files.h"

namespace lanthorn::module_images {
namespace {

TEST(ModuleImage, RadianceByHand) {
    const ImageF image =
        read(radiance("", "-Y 2 +X 2", kOne + kRed + kBlack + std::string("\x40\x20\x10\x88", 4)));
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.channels, 3);
    EXPECT_TRUE(image.linear);
    const std::vector<float> expected = {1, 1, 1, 255.0f / 256, 0, 0, 0, 0, 0, 64, 32, 16};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(image.pixels[i], expected[i], 0.01f * expected[i]) << i;
    }
}

// Radiance's own programs multiply by each EXPOSURE as they brighten a picture.
TEST(ModuleImage, ExposureOfRadianceIsTakenOut) {
    const float one = read(radiance("", "-Y 1 +X 1", kOne)).pixels[0];
    EXPECT_FLOAT_EQ(read(radiance("EXPOSURE=2\n", "-Y 1 +X 1", kOne)).pixels[0], one / 2);
    EXPECT_FLOAT_EQ(read(radiance("EXPOSURE=2\nEXPOSURE= 0.125\n", "-Y 1 +X 1", kOne)).pixels[0], 4 * one);
    for (const char* line :
         {"EXPOSURE=0\n", "EXPOSURE=-1\n", "EXPOSURE=nan\n", "EXPOSURE=\n", "EXPOSURE=1e999\n"}) {
        EXPECT_FLOAT_EQ(read(radiance(line, "-Y 1 +X 1", kOne)).pixels[0], one) << line;
    }
}

// White stays white; red of the widest primaries lies beyond BT.709's.
TEST(ModuleImage, PrimariesOfRadiance) {
    const std::string wide = "PRIMARIES= 0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290\n";
    const std::string equal = "PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n";
    expect_pixel(read(radiance(wide, "-Y 1 +X 1", rgbe({1, 1, 1}))), {1, 1, 1});
    expect_pixel(read(radiance(equal, "-Y 1 +X 1", rgbe({3, 3, 3}))), {3, 3, 3});
    // ITU-R BT.2087-0, annex 2: the inverse of its matrix M2.
    expect_pixel(read(radiance(wide, "-Y 1 +X 1", rgbe({1, 0, 0}))), {1.6605f, -0.1246f, -0.0182f});
    expect_pixel(read(radiance(wide, "-Y 1 +X 1", rgbe({0, 1, 0}))), {-0.5876f, 1.1329f, -0.1006f});
    const std::string plain = "PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\n";
    for (const std::string& lines :
         {plain, std::string("PRIMARIES=\n"), std::string("PRIMARIES=1 2 3\n"),
          std::string("PRIMARIES=0 0 0 0 0 0 0 0\n"), std::string("PRIMARIES=nan 1 1 1 1 1 1 1\n"),
          std::string("PRIMARIES=.1 .1 .2 .2 .3 .3 .2 .2\n")}) {
        EXPECT_EQ(read(radiance(lines, "-Y 1 +X 1", rgbe({4, 2, 1}))).pixels,
                  read(radiance("", "-Y 1 +X 1", rgbe({4, 2, 1}))).pixels)
            << lines;
    }
}

TEST(ModuleImage, RadianceOfXyz) {
    const auto xyz = [](const std::string& lines, const std::array<double, 3>& colour) {
        std::string file = radiance(lines, "-Y 1 +X 1", rgbe(colour));
        file.replace(file.find("rgbe"), 4, "xyze");
        return read(file);
    };
    expect_pixel(xyz("", {0.9505, 1, 1.0891}), {1, 1, 1});  // D65
    // (4, 2, 1) by the matrix of IEC 61966-2-1.
    expect_pixel(xyz("EXPOSURE=2\n", {2 * 2.5454, 2 * 2.3532, 2 * 1.2660}), {4, 2, 1});
    expect_pixel(xyz("", {0.4124, 0.2126, 0.0193}), {1, 0, 0});
}

TEST(ModuleImage, RadianceInEachOrderOfRowsAndColumns) {
    const auto rows = [](const std::string& names) {
        std::string all;
        for (const char name : names) {
            all += std::string("\x80\x80\x80", 3) + char(0x81 - 0x100 + (name - 'a'));
        }
        return all;
    };
    const ImageF expected = read(radiance("", "-Y 2 +X 3", rows("abcdef")));
    const std::vector<std::pair<std::string, std::string>> orders = {
        {"+Y 2 +X 3", "defabc"}, {"-Y 2 -X 3", "cbafed"}, {"+Y 2 -X 3", "fedcba"}, {"+X 3 -Y 2", "adbecf"},
        {"+X 3 +Y 2", "daebfc"}, {"-X 3 -Y 2", "cfbead"}, {"-X 3 +Y 2", "fcebda"}};
    for (const auto& [size, names] : orders) {
        const ImageF image = read(radiance("", size, rows(names)));
        EXPECT_EQ(image.width, 3) << size;
        EXPECT_EQ(image.pixels, expected.pixels) << size;
    }
}

}  // namespace
}  // namespace lanthorn::module_images
