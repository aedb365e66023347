// Radiance pictures: every way to store rows, every order of them, and damage.
#include "engine/assets/hdr_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "tests/unit/assets/refused_file.h"

namespace lanthorn {
namespace {

ImageF read(const std::string& file) {
    return read_hdr("a.hdr", {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
}

std::string with_header(const std::string& size, const std::string& rows) {
    return "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n" + size + "\n" + rows;
}

void expect_refused(const std::string& file, const std::string& part) {
    expect_refused_as(
        "a.hdr", [&] { read(file); }, part);
}

// Powers of two and bytes: 128 * 2^(129 - 136) is 1.
const std::string kOne("\x80\x80\x80\x81", 4), kRed("\xff\x00\x00\x80", 4), kBlack(4, '\0');

TEST(HdrImage, PixelsByHand) {
    const ImageF image =
        read(with_header("-Y 2 +X 2", kOne + kRed + kBlack + std::string("\x40\x20\x10\x88", 4)));
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.pixels, (std::vector<float>{1, 1, 1, 255.0f / 256, 0, 0, 0, 0, 0, 64, 32, 16}));
}

TEST(HdrImage, EachOrderOfRowsAndColumns) {
    // a b c
    // d e f, of exponents that tell them apart.
    const auto pixel = [](char name) {
        return std::string("\x80\x80\x80", 3) + char(0x81 - 0x100 + (name - 'a'));
    };
    const auto rows = [&](const std::string& names) {
        std::string all;
        for (const char name : names) {
            all += pixel(name);
        }
        return all;
    };
    const ImageF expected = read(with_header("-Y 2 +X 3", rows("abcdef")));
    EXPECT_EQ(expected.at(2, 0, 1), 4);
    EXPECT_EQ(expected.at(0, 1, 1), 8);
    const std::vector<std::pair<std::string, std::string>> orders = {
        {"+Y 2 +X 3", "defabc"}, {"-Y 2 -X 3", "cbafed"}, {"+Y 2 -X 3", "fedcba"}, {"+X 3 -Y 2", "adbecf"},
        {"+X 3 +Y 2", "daebfc"}, {"-X 3 -Y 2", "cfbead"}, {"-X 3 +Y 2", "fcebda"}};
    for (const auto& [size, names] : orders) {
        const ImageF image = read(with_header(size, rows(names)));
        EXPECT_EQ(image.width, 3) << size;
        EXPECT_EQ(image.pixels, expected.pixels) << size;
    }
}

// Ward's first: a pixel of mantissas 1 repeats the one before as often as its exponent says; another after it
// 256 times as often.
TEST(HdrImage, RunsOfPixels) {
    const auto again = [](int times) { return std::string("\1\1\1", 3) + char(times); };
    const ImageF image = read(with_header("-Y 1 +X 264", kRed + kOne + again(5) + again(1) + kRed));
    for (int x = 0; x < 264; ++x) {
        EXPECT_EQ(image.at(x, 0, 1), x > 0 && x < 263 ? 1 : 0) << x;
    }
    expect_refused(with_header("-Y 1 +X 4", kOne + again(4)), "a run is longer than row 0");
    expect_refused(with_header("-Y 1 +X 4", again(4)), "a run is longer than row 0");
    std::string endless = kOne;
    for (int i = 0; i < 20; ++i) {
        endless += again(0);
    }
    expect_refused(with_header("-Y 1 +X 4", endless + again(1)), "a run is longer than row 0");
}

TEST(HdrImage, RunsOfPlanes) {
    // Ten pixels: a run of 7 and three by themselves for red; runs of 10 for the others.
    const std::string row(
        "\2\2\0\x0a"
        "\x87\x80\3\x10\x20\x40"
        "\x8a\x08"
        "\x8a\x04"
        "\x8a\x81",
        16);
    const ImageF image = read(with_header("-Y 1 +X 10", row));
    const std::vector<float> red = {1, 1, 1, 1, 1, 1, 1, 0.125f, 0.25f, 0.5f};
    for (int x = 0; x < 10; ++x) {
        EXPECT_EQ(image.at(x, 0, 0), red[static_cast<std::size_t>(x)]);
        EXPECT_EQ(image.at(x, 0, 1), 0.0625f);
        EXPECT_EQ(image.at(x, 0, 2), 0.03125f);
    }
    std::string longer = row;
    longer[4] = '\x8b';  // 11
    expect_refused(with_header("-Y 1 +X 10", longer), "a run is longer than row 0");
    std::string none = row;
    none[4] = '\0';
    expect_refused(with_header("-Y 1 +X 10", none), "a run is longer than row 0");
    expect_refused(with_header("-Y 1 +X 11", row), "row 0 is of 10 pixels, expected 11");
    expect_refused(with_header("-Y 2 +X 10", row + row.substr(0, 9)), "the file is cut off in row 1");
}

// Each run continues the one before: 2^28 pixels of 32 bytes.
TEST(HdrImage, RunsThatPackWithoutBound) {
    std::string runs = kOne;
    for (const int times : {255, 255, 255, 15}) {
        runs += std::string("\1\1\1", 3) + char(times);
    }
    expect_refused(with_header("-Y 1 +X 268435456", runs),
                   "has 268435456 x 1 texels in 20 bytes, more than are taken from so few");
}

// A picture of one colour, larger than what is taken from any file.
TEST(HdrImage, AFlatPictureIsRead) {
    const ImageF image{4200, 4100, 3, std::vector<float>(std::size_t{4200} * 4100 * 3, 0.5f), {}};
    EXPECT_EQ(read(hdr_bytes(image)).pixels, image.pixels);
}

TEST(HdrImage, BlanksAroundWhatHeadersSay) {
    const ImageF image = read("#?RADIANCE\nFORMAT= 32-bit_rle_rgbe \t\r\n\r\n-Y 1 +X 1 \r\n" + kOne);
    EXPECT_EQ(image.pixels, (std::vector<float>{1, 1, 1}));
}

// Half a step of eight bits below the largest of the three, for sizes with and without runs.
TEST(HdrImage, WhatIsWrittenComesBack) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(7, 3), std::pair(8, 2), std::pair(301, 5)}) {
        ImageF image{width, height, 3, {}, {}};
        for (int i = 0; i < width * height; ++i) {
            const float base = std::ldexp(1.0f + 0.013f * static_cast<float>(i % 61), i % 23 - 11);
            const bool flat = i % 301 > 100;  // long runs
            image.pixels.insert(image.pixels.end(), {flat ? 3.0f : base, flat ? 2.0f : 0.7f * base, 0});
        }
        const ImageF back = read(hdr_bytes(image));
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const float largest = image.pixels[i / 3 * 3];
            EXPECT_NEAR(back.pixels[i], image.pixels[i], largest / 256 * 1.0001f) << i;
        }
    }
}

TEST(HdrImage, ValuesAtTheEnds) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float largest = std::ldexp(255.0f, 119);
    const ImageF image{
        4, 1, 3, {kInfinity, 3e38f, 1, std::nanf(""), -5, 0.999f, 255.6f, 1, 0, 1e-45f, 0, 0}, {}};
    EXPECT_EQ(read(hdr_bytes(image)).pixels,
              (std::vector<float>{largest, largest, 0, 0, 0, 1, 256, 2, 0, 0, 0, 0}));
}

TEST(HdrImage, HeadersThatAreNone) {
    expect_refused("#?RADIANCE\n", "its header has no end");
    expect_refused("#?RADIANCE\n\n", "its header has no end");
    expect_refused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + kOne,
                   "found FORMAT=32-bit_rle_xyze");
    for (const char* size : {"", "-Y 2", "-Y 2 +Y 2", "-Y x +X 2", "-Y -2 +X 2", "Y 2 X 2", "-Y 2 +X 2 3",
                             "-Y 1 +X 1z", "-Y 1z+X 1", "-Y 99999999999999999999 +X 1"}) {
        expect_refused(with_header(size, kOne), "found the size '");
    }
    expect_refused(with_header("-Y 0 +X 2", kOne), "has 2 x 0 texels");
    expect_refused(with_header("-Y 4294967296 +X 4294967296", kOne), "texels, expected 1 to");
    expect_refused(with_header("-Y 4096 +X 4096", kOne), "the file is cut off in row 0");
    expect_refused(with_header("-Y 16384 +X 16384", kOne),
                   "has 16384 x 16384 texels in 4 bytes, more than are taken from so few");
    expect_refused("#?RADIANCE\n" + std::string(10000, 'x') + "\n\n-Y 1 +X 1\n" + kOne,
                   "its header has no end");
}

}  // namespace
}  // namespace lanthorn
