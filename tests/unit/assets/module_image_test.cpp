// Images that OpenImageIO reads: what is written comes back, and what damage costs.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "engine/assets/image_decode.h"
#include "engine/assets/image_module_file.h"
#include "tests/unit/assets/module_image_files.h"
#include "tests/unit/assets/refused_file.h"

namespace lanthorn::module_images {
namespace {

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

}  // namespace
}  // namespace lanthorn::module_images
