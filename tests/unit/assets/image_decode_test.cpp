// Textures: PNG, JPEG and WebP to texels, whole, odd and damaged.
#include "engine/assets/image_decode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/unit/assets/image_files.h"

namespace lanthorn {
namespace {

using Texels = std::vector<std::uint8_t>;

std::string little_endian(std::size_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text.push_back(static_cast<char>(value >> (8 * i) & 0xff));
    }
    return text;
}

std::string chunk(const std::string& name, const std::string& content) {
    return name + little_endian(content.size(), 4) + content + std::string(content.size() % 2, '\0');
}

// An animation of one frame of 2 x 1 texels at (x, y), both even, of a canvas; `still` is a WebP file.
std::string webp_frame(std::size_t width, std::size_t height, std::size_t x, std::size_t y,
                       const std::string& still) {
    const std::string flags("\2\0\0\0", 4);
    const std::string size = little_endian(width - 1, 3) + little_endian(height - 1, 3);
    const std::string frame = little_endian(x / 2, 3) + little_endian(y / 2, 3) + little_endian(1, 3) +
                              little_endian(0, 3) + little_endian(40, 3) + '\0' + still.substr(12);
    return chunk("RIFF", "WEBP" + chunk("VP8X", flags + size) + chunk("ANIM", std::string(6, '\0')) +
                             chunk("ANMF", frame));
}

std::span<const std::uint8_t> as_bytes(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

DecodedImage decoded(const std::string& file) {
    return decode_image(as_bytes(file));
}

Texels whole(const std::string& file, std::uint32_t width, std::uint32_t height) {
    const DecodedImage result = decoded(file);
    EXPECT_EQ(result.problem, "");
    EXPECT_EQ(result.note, "");
    EXPECT_EQ(result.image.width, width);
    EXPECT_EQ(result.image.height, height);
    EXPECT_EQ(stated_texels(as_bytes(file)), std::uint64_t{width} * height);
    return result.image.rgba;
}

// Smooth, so that JPEG keeps it well.
Texels slope(int width, int height, int channels) {
    Texels texels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                texels.push_back(static_cast<std::uint8_t>(20 + 5 * x + 3 * y + 40 * c));
            }
        }
    }
    return texels;
}

void expect_near(const Texels& a, const Texels& b, int most) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_NEAR(a[i], b[i], most) << i;
    }
}

Texels with_alpha(const Texels& rgb) {
    Texels rgba;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
    }
    return rgba;
}

TEST(ImageDecode, PngOfOddSizesAndOfAPalette) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(5, 3), std::pair(17, 1), std::pair(1, 9)}) {
        const Texels texels = slope(width, height, 3);
        EXPECT_EQ(whole(make_png(width, height, texels, 3), width, height), with_alpha(texels));
    }
    const Texels colours = {10, 20, 30, 200, 0, 0};
    for (const int bits : {1, 2, 8}) {
        EXPECT_EQ(whole(make_palette_png(3, 1, {1, 0, 1}, bits, colours, {128}), 3, 1),
                  (Texels{200, 0, 0, 255, 10, 20, 30, 128, 200, 0, 0, 255}));
    }
}

TEST(ImageDecode, JpegOfOddSizesGreyAndProgressive) {
    for (const JpegKind kind : {JpegKind::baseline, JpegKind::progressive}) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(17, 9), std::pair(8, 23)}) {
            const Texels texels = slope(width, height, 3);
            expect_near(whole(make_jpeg(width, height, texels, 3, kind), width, height), with_alpha(texels),
                        3);
        }
        const Texels grey = whole(make_jpeg(2, 1, {50, 50}, 1, kind), 2, 1);
        expect_near(grey, {50, 50, 50, 255, 50, 50, 50, 255}, 1);
    }
}

// 255 is no ink; Adobe's programs store ink inverted.
TEST(ImageDecode, JpegInInksBecomesRgb) {
    const Texels inks = {0, 128, 255, 51};  // as stored
    expect_near(whole(make_jpeg(1, 1, inks, 4, JpegKind::adobe_cmyk), 1, 1), {0, 26, 51, 255}, 2);
    expect_near(whole(make_jpeg(1, 1, inks, 4, JpegKind::cmyk), 1, 1), {204, 102, 0, 255}, 2);
}

// What is there is shown, and told.
TEST(ImageDecode, CutJpegIsReadAsFarAsItGoes) {
    const Texels texels = slope(40, 32, 3);
    for (const JpegKind kind : {JpegKind::baseline, JpegKind::progressive}) {
        const std::string file = make_jpeg(40, 32, texels, 3, kind);
        const DecodedImage cut = decoded(file.substr(0, file.size() * 3 / 4));
        EXPECT_EQ(cut.problem, "");
        EXPECT_EQ(cut.note, "the image is damaged (the file is cut off); what is missing is grey");
        ASSERT_EQ(cut.image.rgba.size(), texels.size() / 3 * 4);
        EXPECT_NEAR(cut.image.rgba[0], texels[0], kind == JpegKind::baseline ? 3 : 30);
    }
}

// The decoder reads ahead of what it decodes, so that it meets the end of the file before that of the image.
TEST(ImageDecode, AJpegWithoutItsEndMarkerIsWhole) {
    for (const JpegKind kind : {JpegKind::baseline, JpegKind::progressive}) {
        for (const int channels : {1, 3}) {
            const std::string file = make_jpeg(21, 18, slope(21, 18, channels), channels, kind);
            ASSERT_TRUE(file.ends_with("\xff\xd9"));
            const std::string unended = file.substr(0, file.size() - 2);
            EXPECT_EQ(whole(unended, 21, 18), whole(file, 21, 18));
            EXPECT_EQ(whole(unended + '\xff', 21, 18), whole(file, 21, 18));
            for (std::size_t size = 0; size < unended.size(); ++size) {
                const DecodedImage cut = decoded(unended.substr(0, size));
                EXPECT_NE(cut.problem + cut.note, "") << size << " of " << unended.size();
            }
        }
    }
}

// The frame's own place; what is around it is transparent.
TEST(ImageDecode, AFrameInAPartOfItsCanvas) {
    EXPECT_EQ(whole(webp_frame(4, 3, 2, 2, make_webp(2, 1, {1, 2, 3, 4, 5, 6})), 4, 3),
              (Texels{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0,  //
                      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0,  //
                      0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 255, 4, 5, 6, 255}));
    const DecodedImage outside = decoded(webp_frame(4, 3, 4, 2, make_webp(2, 1, {1, 2, 3, 4, 5, 6})));
    EXPECT_EQ(outside.problem, "cannot be decoded: the file is damaged");
}

TEST(ImageDecode, WebpKeepsAlphaApart) {
    const Texels texels = {255, 2, 0, 128, 9, 8, 7, 255, 250, 100, 50, 1};
    EXPECT_EQ(whole(make_webp(3, 1, texels, 4), 3, 1), texels);
    EXPECT_EQ(whole(make_webp(1, 1, {1, 2, 3}), 1, 1), (Texels{1, 2, 3, 255}));
    const Texels odd = slope(13, 7, 3);
    EXPECT_EQ(whole(make_webp(13, 7, odd), 13, 7), with_alpha(odd));
}

TEST(ImageDecode, OfAnAnimationTheFirstPicture) {
    Texels first, second;
    for (int i = 0; i < 6 * 5; ++i) {
        first.insert(first.end(), {200, static_cast<std::uint8_t>(i), 0, 200});
        second.insert(second.end(), {0, static_cast<std::uint8_t>(3 * i), 90, 255});
    }
    EXPECT_EQ(whole(make_animated_webp(6, 5, {first, second}), 6, 5), first);
}

// Every beginning of a file and every single damaged byte: one line, or texels of the stated size.
TEST(ImageDecode, DamageIsToldOrDoesNoHarm) {
    const Texels rgb = slope(11, 6, 3);
    const Texels frame = slope(11, 6, 4);
    const std::vector<std::string> files = {
        make_png(11, 6, rgb, 3), make_jpeg(11, 6, rgb, 3), make_jpeg(11, 6, rgb, 3, JpegKind::progressive),
        make_webp(11, 6, rgb), make_animated_webp(11, 6, {frame, Texels(frame.rbegin(), frame.rend())})};
    int refused = 0;
    const auto check = [&](const std::string& damaged) {
        const DecodedImage result = decoded(damaged);
        EXPECT_EQ(result.problem.empty(), !result.image.rgba.empty());
        EXPECT_EQ(result.image.rgba.size(), std::size_t{4} * result.image.width * result.image.height);
        EXPECT_EQ((result.problem + result.note).find('\n'), std::string::npos);
        refused += result.problem.empty() ? 0 : 1;
    };
    for (const std::string& file : files) {
        for (std::size_t i = 0; i < file.size(); ++i) {
            check(file.substr(0, i));
            std::string damaged = file;
            damaged[i] = static_cast<char>(damaged[i] ^ (i % 2 == 0 ? 0xff : 0x10));
            // Sizes above are for AHeaderAloneTakesNoMemory.
            if (stated_texels(as_bytes(damaged)) <= 1u << 16) {
                check(damaged);
            }
        }
    }
    EXPECT_GT(refused, 500);
}

// Both sides are 16383.
TEST(ImageDecode, AHeaderAloneTakesNoMemory) {
    std::string jpeg = make_jpeg(1, 1, {9, 9, 9}, 3);
    const std::size_t frame_of_jpeg = jpeg.find("\xff\xc0");
    ASSERT_NE(frame_of_jpeg, std::string::npos);
    jpeg.replace(frame_of_jpeg + 5, 4, "\x3f\xff\x3f\xff");
    EXPECT_EQ(stated_texels(as_bytes(jpeg)), 0u);
    const DecodedImage result = decoded(jpeg);
    EXPECT_TRUE(result.problem.starts_with("has 16383 x 16383 texels in ")) << result.problem;

    jpeg.replace(frame_of_jpeg + 5, 4, "\xff\xff\xff\xff");  // 65535: JPEG's largest is 65500
    EXPECT_NE(decoded(jpeg).problem, "");

    std::string webp = make_webp(1, 1, {9, 9, 9});
    ASSERT_EQ(webp.substr(12, 4), "VP8L");
    webp.replace(21, 3, "\xfe\xbf\xff");  // 14 bits each, of the size less one; the rest is in the next byte
    webp[24] = static_cast<char>((webp[24] & 0xf0) | 0x0f);
    const std::string frame = webp_frame(16383, 16383, 0, 0, make_webp(2, 1, {1, 2, 3, 4, 5, 6}));
    for (const std::string& file : {webp, frame}) {
        EXPECT_EQ(stated_texels(as_bytes(file)), 0u);
        const DecodedImage large = decoded(file);
        EXPECT_EQ(large.problem, "has 16383 x 16383 texels in " + std::to_string(file.size()) +
                                     " bytes, more than are taken from so few");
    }
    jpeg.replace(frame_of_jpeg + 1, 1, "\xc9");  // in arithmetic codes
    jpeg.replace(frame_of_jpeg + 5, 4, "\x3f\xff\x3f\xff");
    EXPECT_EQ(stated_texels(as_bytes(jpeg)), 0u);
    EXPECT_TRUE(decoded(jpeg).problem.starts_with("has 16383 x 16383 texels in ")) << decoded(jpeg).problem;
}

// What libwebp makes of a single colour packs better than pictures do, and is taken.
TEST(ImageDecode, AFlatWebpIsRead) {
    constexpr int kSide = 4200;
    const std::string file = make_webp(kSide, kSide, Texels(3 * kSide * kSide, 200));
    EXPECT_GT(std::size_t{kSide} * kSide / file.size(), 16384u);
    EXPECT_EQ(whole(file, kSide, kSide).size(), std::size_t{4} * kSide * kSide);
}

// libpng would make room for the chunk before it looks for it.
TEST(ImageDecode, AChunkLongerThanTheFile) {
    std::string png = make_png(2, 1, {1, 2, 3, 4, 5, 6}, 3);
    png.insert(33, std::string("\x7f\0\0\0eXIf", 8));  // behind the header
    EXPECT_EQ(decoded(png).problem, "cannot be decoded: the file is cut off");
    EXPECT_EQ(stated_texels(as_bytes(png)), 0u);
}

TEST(ImageDecode, WhatIsNoImage) {
    EXPECT_EQ(decoded("").problem, "is of no image format that is known");
    EXPECT_EQ(decoded("BM no longer").problem, "is of no image format that is known");
    EXPECT_NE(decoded(std::string("\xABKTX 20\xBB\r\n\x1A\n", 12)).problem.find("KTX2"), std::string::npos);
    EXPECT_NE(decoded("\xff\xd8\xff").problem, "");
    EXPECT_EQ(decoded(std::string("RIFF\4\0\0\0WEBP", 12)).problem, "cannot be decoded: the file is damaged");
}

}  // namespace
}  // namespace lanthorn
