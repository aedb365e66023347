// OpenEXR's pictures as OpenImageIO reads them: primaries, windows, luminance and chroma, and levels.
#include <ImfChannelList.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include "tests/unit/assets/module_image_files.h"
#include "tests/unit/assets/refused_file.h"

namespace lanthorn::module_images {
namespace {

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

}  // namespace
}  // namespace lanthorn::module_images
