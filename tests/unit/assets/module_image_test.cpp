// Images that OpenImageIO reads: what becomes of them, and what damage costs.
#include "engine/assets/module_image.h"

#include <ImfChannelList.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <span>

#include "engine/assets/image_decode.h"
#include "engine/assets/image_format.h"
#include "engine/assets/image_module_file.h"
#include "lanthorn/assets/image_io.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/refused_file.h"

namespace lanthorn {
namespace module_image_test {

std::span<const std::uint8_t> as_bytes(const std::string& file) {
    return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
}

ImageF read(const std::string& file, const std::string& ending = "") {
    return read_by_module("a", as_bytes(file), format_to_read(as_bytes(file), ending));
}

ImageF ramp(int width, int height, int channels) {
    ImageF image{width, height, channels, {}, {}};
    for (int i = 0; i < width * height * channels; ++i) {
        image.pixels.push_back(static_cast<float>(i % 255) / 255);
    }
    return image;
}

std::string radiance(const std::string& lines, const std::string& size, const std::string& rows) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n" + size + "\n" + rows;
}

// Little-endian entries of a TIFF of one strip.
std::string tiff(int width, int height, int samples, const std::string& pixels,
                 const std::vector<std::pair<int, int>>& more) {
    std::vector<std::pair<int, int>> tags = {
        {256, width},   {257, height}, {258, 8},
        {259, 1},       {262, 2},      {273, 8},
        {277, samples}, {278, height}, {279, static_cast<int>(pixels.size())}};
    tags.insert(tags.end(), more.begin(), more.end());
    std::ranges::sort(tags);
    const auto number = [](unsigned value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) {
            text.push_back(static_cast<char>(value >> (8 * i)));
        }
        return text;
    };
    std::string body = pixels + (pixels.size() % 2 != 0 ? "\0" : "");
    std::string file = std::string("II*\0", 4) + number(static_cast<unsigned>(8 + body.size()), 4) + body +
                       number(static_cast<unsigned>(tags.size()), 2);
    for (const auto& [tag, value] : tags) {
        file += number(static_cast<unsigned>(tag), 2) + number(tag == 273 || tag == 279 ? 4 : 3, 2) +
                number(1, 4) + number(static_cast<unsigned>(value), 4);
    }
    return file + number(0, 4);
}

// 32-bit RGB of (4, 2, 1) in a window of a picture.
std::string windowed(const Imath::Box2i& full, const Imath::Box2i& window) {
    Imf::Header header(full, window);
    header.compression() = Imf::NO_COMPRESSION;
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::vector<float> pixels;
    for (int i = 0; i < width * height; ++i) {
        pixels.insert(pixels.end(), {4, 2, 1});
    }
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        const char name[] = {"RGB"[c], '\0'};
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &pixels[static_cast<std::size_t>(c)], window, 12,
                                            static_cast<std::size_t>(12 * width)));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(height);
    }
    return stream.str();
}

const std::string kOne("\x80\x80\x80\x81", 4), kRed("\xff\x00\x00\x80", 4), kBlack(4, '\0');

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

class ModuleFiles : public testing::Test {
  protected:
    std::string file(const char* name, int channels, int width = 12, int height = 9) {
        write_image(folder.path() / name, ramp(width, height, channels));
        std::ifstream stream(folder.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    TemporaryFolder folder;
};

constexpr float kStepsOfRgbe = 4 / 256.0f;  // of the largest value; a matrix adds up those of three

void expect_pixel(const ImageF& image, const std::array<float, 3>& expected, float tolerance = kStepsOfRgbe) {
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(image.at(0, 0, static_cast<int>(c)), expected[c], tolerance * std::ranges::max(expected))
            << c;
    }
}

// RGBE of 8 bits and a shared exponent.
std::string rgbe(const std::array<double, 3>& colour) {
    const double most = std::max({colour[0], colour[1], colour[2]});
    int exponent = 0;
    std::frexp(most, &exponent);
    std::string pixel;
    for (const double value : colour) {
        pixel.push_back(static_cast<char>(static_cast<int>(std::ldexp(value, 8 - exponent))));
    }
    return pixel + static_cast<char>(exponent + 128);
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

std::string exr_of_primaries(const Imf::Chromaticities& primaries, const Imf::Rgba& colour, bool tiled) {
    Imf::Header header(2, 2);
    Imf::addChromaticities(header, primaries);
    if (tiled) {
        header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
    }
    std::vector<float> pixels;
    for (int i = 0; i < 4; ++i) {
        pixels.insert(pixels.end(), {colour.r, colour.g, colour.b});
    }
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        const char name[] = {"RGB"[c], '\0'};
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice(Imf::FLOAT,
                                      reinterpret_cast<char*>(&pixels[static_cast<std::size_t>(c)]), 12, 24));
    }
    Imf::StdOSStream stream;
    if (tiled) {
        Imf::TiledOutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writeTiles(0, 0, 0, 0, 0);
    } else {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    return stream.str();
}

// As OpenEXR reads them, and as OpenImageIO does.
TEST_F(ModuleFiles, PrimariesOfExr) {
    const Imf::Chromaticities wide({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f});
    const Imf::Chromaticities aces({0.7347f, 0.2653f}, {0, 1}, {0.0001f, -0.0770f}, {0.32168f, 0.33767f});
    for (const bool tiled : {false, true}) {
        const auto image = [&](const Imf::Chromaticities& primaries, const Imf::Rgba& colour) {
            return read_image(folder.write("a.exr", exr_of_primaries(primaries, colour, tiled)));
        };
        expect_pixel(image(wide, {1, 0, 0}), {1.6605f, -0.1246f, -0.0182f}, 2e-4f);
        expect_pixel(image(wide, {2, 2, 2}), {2, 2, 2}, 2e-4f);
        expect_pixel(image(aces, {1, 1, 1}), {1, 1, 1}, 2e-4f);
        // The matrix of S-2014-003's AP0 to BT.709 by Bradford.
        expect_pixel(image(aces, {0, 1, 0}), {-1.1341f, 1.3727f, -0.1530f}, 2e-4f);
        EXPECT_EQ(image(Imf::Chromaticities(), {4, 2, 1}).pixels[0], 4);
    }
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

// Outside of the data window there is nothing; what lies outside of the display window is not shown.
TEST(ModuleImage, WindowsOfExr) {
    const ImageF crop = read(windowed({{0, 0}, {31, 15}}, {{8, 4}, {23, 11}}));
    ASSERT_EQ(crop.width, 32);
    ASSERT_EQ(crop.height, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const bool inside = x >= 8 && x < 24 && y >= 4 && y < 12;
            EXPECT_EQ(crop.at(x, y, 0), inside ? 4 : 0) << x << ',' << y;
            EXPECT_EQ(crop.at(x, y, 2), inside ? 1 : 0) << x << ',' << y;
        }
    }
    const ImageF overscan = read(windowed({{-2, 1}, {5, 4}}, {{-5, -3}, {9, 9}}));
    EXPECT_EQ(overscan.width, 8);
    EXPECT_EQ(overscan.height, 4);
    EXPECT_EQ(overscan.pixels.back(), 1);
    EXPECT_EQ(overscan.pixels.front(), 4);
    const ImageF apart = read(windowed({{0, 0}, {7, 3}}, {{20, 20}, {21, 21}}));
    EXPECT_EQ(apart.pixels, std::vector<float>(8 * 4 * 3));
}

// Chroma has a quarter of the pixels; alpha and windows go with it.
TEST(ModuleImage, LuminanceAndChromaOfExr) {
    const Imath::Box2i full({0, 0}, {31, 15});
    for (const Imath::Box2i& window :
         {full, Imath::Box2i({8, 4}, {23, 11}), Imath::Box2i({-4, -2}, {29, 13})}) {
        for (const auto channels : {Imf::WRITE_YC, Imf::WRITE_YCA}) {
            Imf::Header header(full, window);
            const int width = window.max.x - window.min.x + 1;
            Imf::StdOSStream stream;
            {
                Imf::RgbaOutputFile file(stream, header, channels, 0);
                const std::vector<Imf::Rgba> pixels(34 * 16, Imf::Rgba(4, 2, 1, 0.5f));
                file.setFrameBuffer(Imf::ComputeBasePointer(pixels.data(), window), 1,
                                    static_cast<std::size_t>(width));
                file.writePixels(window.max.y - window.min.y + 1);
            }
            const ImageF image = read(stream.str());
            ASSERT_EQ(image.width, 32);
            ASSERT_EQ(image.height, 16);
            ASSERT_EQ(image.channels, channels == Imf::WRITE_YC ? 3 : 4);
            EXPECT_TRUE(image.linear);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(image.at(15, 7, c), 4 >> c, 0.05f) << c;
            }
            EXPECT_EQ(image.at(15, 7, image.channels - 1),
                      channels == Imf::WRITE_YC ? image.at(15, 7, 2) : 0.5f);
            EXPECT_EQ(image.at(31, 15, 0) > 0, window == full);
        }
    }
}

// The chroma is of the primaries that the file states.
TEST(ModuleImage, LuminanceAndChromaOfOtherPrimaries) {
    Imf::Header header(8, 8);
    Imf::addChromaticities(header, Imf::Chromaticities({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f},
                                                       {0.3127f, 0.3290f}));
    Imf::StdOSStream stream;
    {
        Imf::RgbaOutputFile file(stream, header, Imf::WRITE_YC, 0);
        const std::vector<Imf::Rgba> pixels(8 * 8, Imf::Rgba(1, 0.5f, 0.5f));
        file.setFrameBuffer(pixels.data(), 1, 8);
        file.writePixels(8);
    }
    // Half of ITU-R BT.2087's column of red, upon half of white.
    expect_pixel(read(stream.str()), {1.3303f, 0.4377f, 0.4909f}, 0.01f);
}

// 32 x 16 in tiles, of which the first `levels` levels are written, all of (4, 2, 1).
std::string exr_of_levels(Imf::LevelMode mode, int levels, const Imf::Compression compression) {
    Imf::Header header(32, 16);
    header.setTileDescription(Imf::TileDescription(16, 16, mode));
    header.compression() = compression;
    std::vector<float> pixels;
    for (int i = 0; i < 32 * 16; ++i) {
        pixels.insert(pixels.end(), {4, 2, 1});
    }
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        const char name[] = {"RGB"[c], '\0'};
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name,
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixels[static_cast<std::size_t>(c)]), 12,
                                12 * 32));
    }
    Imf::StdOSStream stream;
    {
        Imf::TiledOutputFile file(stream, header, 0);
        file.setFrameBuffer(frame);
        for (int level = 0; level < levels; ++level) {
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level, level);
        }
    }
    return stream.str();
}

// The picture is the largest level; programs that stopped before the small ones left it whole.
TEST(ModuleImage, SmallLevelsOfExrThatWereNotWritten) {
    for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::ZIP_COMPRESSION}) {
        const std::string first = exr_of_levels(Imf::MIPMAP_LEVELS, 1, compression);
        const std::string cut = exr_of_levels(Imf::MIPMAP_LEVELS, 6, compression).substr(0, first.size());
        for (const std::string& file : {first, exr_of_levels(Imf::MIPMAP_LEVELS, 2, compression),
                                        exr_of_levels(Imf::MIPMAP_LEVELS, 6, compression),
                                        exr_of_levels(Imf::RIPMAP_LEVELS, 1, compression), cut}) {
            const ImageF image = read(file);
            ASSERT_EQ(image.width, 32);
            ASSERT_EQ(image.height, 16);
            for (int y = 0; y < 16; ++y) {
                for (int x = 0; x < 32; ++x) {
                    ASSERT_EQ(image.at(x, y, 0), 4) << x << ',' << y;
                    ASSERT_EQ(image.at(x, y, 2), 1) << x << ',' << y;
                }
            }
        }
        const std::string none = exr_of_levels(Imf::MIPMAP_LEVELS, 0, compression);
        expect_refused_as(
            "a", [&] { read(none); }, "cannot be read to its end");
    }
}

TEST(ModuleImage, OrientationOfTiff) {
    // a b c
    // d e f
    const auto rows = [](const std::string& names) {
        std::string all;
        for (const char name : names) {
            all += std::string(3, name);
        }
        return all;
    };
    const ImageF expected = read(tiff(3, 2, 3, rows("abcdef"), {}));
    EXPECT_FLOAT_EQ(expected.at(1, 1, 0), 'e' / 255.0f);
    EXPECT_FALSE(expected.linear);
    const std::vector<std::tuple<int, int, int, std::string>> orders = {
        {2, 3, 2, "cbafed"}, {3, 3, 2, "fedcba"}, {4, 3, 2, "defabc"}, {5, 2, 3, "adbecf"},
        {6, 2, 3, "cfbead"}, {7, 2, 3, "fcebda"}, {8, 2, 3, "daebfc"}};
    for (const auto& [orientation, width, height, names] : orders) {
        const ImageF image = read(tiff(width, height, 3, rows(names), {{274, orientation}}));
        EXPECT_EQ(image.width, 3) << orientation;
        EXPECT_EQ(image.pixels, expected.pixels) << orientation;
    }
}

TEST(ModuleImage, AlphaIsNotMultipliedIn) {
    const std::string pixel("\x40\x20\x10\x80", 4);
    const ImageF apart = read(tiff(1, 1, 4, pixel, {{338, 2}}));
    EXPECT_FLOAT_EQ(apart.pixels[0], 64 / 255.0f);
    EXPECT_FLOAT_EQ(apart.pixels[3], 128 / 255.0f);
    const ImageF within = read(tiff(1, 1, 4, pixel, {{338, 1}}));
    EXPECT_NEAR(within.pixels[0], 0.5f, 1e-4f);
    EXPECT_NEAR(within.pixels[2], 0.125f, 1e-4f);
    EXPECT_FLOAT_EQ(within.pixels[3], 128 / 255.0f);
}

TEST_F(ModuleFiles, WhatIsWrittenComesBack) {
    for (const char* name : {"a.tif", "a.bmp", "a.tga", "a.dpx", "a.ppm", "a.iff"}) {
        const ImageF image = ramp(12, 9, 3);
        write_image(folder.path() / name, image);
        const ImageF back = read_image(folder.path() / name);
        ASSERT_EQ(back.width, 12) << name;
        ASSERT_EQ(back.channels, 3) << name;
        EXPECT_EQ(back.linear, holds_linear(name)) << name;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            ASSERT_NEAR(back.pixels[i], image.pixels[i], 1e-3f) << name << ' ' << i;
        }
    }
    for (const char* name : {"a.tif", "a.tga"}) {
        const ImageF clear{1, 1, 4, {1, 0.2f, 0, 0.4f}, {}};
        write_image(folder.path() / name, clear);
        const ImageF back = read_image(folder.path() / name);
        ASSERT_EQ(back.channels, 4) << name;
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(back.pixels[c], clear.pixels[c], 1e-5f) << name << ' ' << c;
        }
    }
    for (const char* name : {"a.jpg", "a.webp"}) {
        write_image(folder.path() / name, ImageF{8, 8, 3, std::vector<float>(192, 0.4f), {}});
        EXPECT_NEAR(read_image(folder.path() / name).pixels[9], 0.4f, 0.01f) << name;
    }
}

TEST_F(ModuleFiles, TexturesOfOtherFormatsAreDecoded) {
    const std::string bmp = file("a.bmp", 3);
    EXPECT_EQ(stated_texels(as_bytes(bmp)), 12u * 9);
    const DecodedImage decoded = decode_image(as_bytes(bmp));
    EXPECT_EQ(decoded.problem, "");
    ASSERT_EQ(decoded.image.rgba.size(), 12u * 9 * 4);
    EXPECT_EQ(decoded.image.rgba[4], 3);
    EXPECT_EQ(decoded.image.rgba[7], 255);
    const DecodedImage cut = decode_image(as_bytes(bmp.substr(0, 60)));
    EXPECT_NE(cut.problem, "");
}

// Each beginning, and bytes damaged all over: one line, or an image of its size.
TEST_F(ModuleFiles, DamageIsToldOrDoesNoHarm) {
    int refused = 0, read_whole = 0;
    const auto check = [&](const std::string& damaged, const std::string& ending) {
        try {
            const ImageF image = read(damaged, ending);
            EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width) *
                                               static_cast<std::size_t>(image.height) *
                                               static_cast<std::size_t>(image.channels));
            ++read_whole;
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++refused;
        }
    };
    for (const char* name : {"a.hdr", "a.tif", "a.bmp", "a.tga", "a.dpx"}) {
        const std::string whole = file(name, 3);
        const std::string ending = std::filesystem::path(name).extension();
        for (std::size_t i = 0; i < whole.size(); i += i < 300 ? 11 : 211) {
            check(whole.substr(0, i), ending);
            std::string damaged = whole;
            damaged[i] = static_cast<char>(damaged[i] ^ (i % 2 == 0 ? 0xff : 0x41));
            check(damaged, ending);
        }
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(read_whole, 10);
}

TEST(ModuleImage, WhatStatesTooMuchIsRefusedAtOnce) {
    const auto before = std::chrono::steady_clock::now();
    const auto refuse = [](const std::string& file, const std::string& part) {
        expect_refused_as(
            "a", [&] { read(file); }, part);
    };
    refuse(radiance("", "-Y 65536 +X 32768", kOne), "");  // 2^31 pixels
    refuse(radiance("", "-Y 16384 +X 16384", kOne), "");  // as many as are read, in 60 bytes
    refuse(windowed({{0, 0}, {60000, 60000}}, {{0, 0}, {1, 1}}), "has 60001 x 60001 pixels");
    refuse(windowed({{0, 0}, {16383, 16383}}, {{0, 0}, {1, 1}}), "more than are taken from so few");
    refuse(tiff(65535, 32767, 3, "abc", {}), "");
    refuse(tiff(1, 1, 1000, std::string(1000, 'a'), {}), "");
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
}

// What another process or user leaves: a module that is not there, no library, cut off, or of another
// version.
class BadModule : public testing::Test {
  protected:
    std::string problem_with(const std::filesystem::path& path) {
        ::setenv("LANTHORN_IMAGE_MODULE", path.c_str(), 1);
        std::string problem;
        const ImageModule* module = load_image_module(image_module_path(), problem);
        ::unsetenv("LANTHORN_IMAGE_MODULE");
        EXPECT_EQ(module, nullptr);
        EXPECT_EQ(problem.find('\n'), std::string::npos);
        EXPECT_NE(problem.find("package lanthorn-images"), std::string::npos) << problem;
        return problem;
    }
    TemporaryFolder folder;
};

TEST_F(BadModule, IsToldInALine) {
    EXPECT_NE(problem_with(folder.path() / "none.so").find("is not there"), std::string::npos);
    EXPECT_NE(problem_with(folder.write("text.so", "no library")).find("is damaged"), std::string::npos);
    std::ifstream stream(image_module_path(), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_GT(whole.size(), 10000u);
    for (const std::size_t size : {std::size_t{64}, std::size_t{5000}, whole.size() / 2, whole.size() - 1}) {
        EXPECT_NE(problem_with(folder.write("cut.so", whole.substr(0, size))).find("is damaged"),
                  std::string::npos)
            << size;
    }
    std::string other = whole;
    const std::string version = image_module_version();
    const std::size_t at = other.find(version);
    ASSERT_NE(at, std::string::npos);
    other[at] = '9';
    EXPECT_NE(problem_with(folder.write("other.so", other)).find("is of version 9"), std::string::npos);
}

}  // namespace module_image_test
}  // namespace lanthorn
