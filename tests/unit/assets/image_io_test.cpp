// Image files: what is written comes back, and files are whole or absent.
#include "lanthorn/assets/image_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "lanthorn/core/error.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/image_files.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

ImageF ramp(int width, int height, int channels, float scale) {
    ImageF image{width, height, channels, {}, {}};
    for (int i = 0; i < width * height * channels; ++i) {
        image.pixels.push_back(scale * static_cast<float>(i));
    }
    return image;
}

class ImageIo : public testing::Test {
  protected:
    std::size_t files_left() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
    }
    void expect_refused(const fs::path& path, const ImageF& image, const std::string& part) const {
        try {
            write_image(path, image);
            ADD_FAILURE() << "wrote " << path;
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_TRUE(line.starts_with(path.string())) << line;
            EXPECT_NE(line.find(part), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    }
    TemporaryFolder folder;
};

TEST_F(ImageIo, ExrKeepsEveryBitAndItsMetadata) {
    for (const int channels : {1, 2, 3, 4}) {
        ImageF image = ramp(5, 3, channels, 1.1e-3f);
        image.at(4, 2, channels - 1) = 1e30f;
        image.at(0, 0, 0) = -2;
        image.metadata = {{"technique", "emc"}, {"seed", "7"}};
        const fs::path path = folder.path() / "a.exr";
        write_image(path, image);
        const ImageF back = read_image(path);
        EXPECT_EQ(back.width, 5);
        EXPECT_EQ(back.height, 3);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.pixels, image.pixels);
        EXPECT_EQ(back.metadata, image.metadata);
    }
    EXPECT_EQ(files_left(), 1u) << "a temporary stayed";
}

TEST_F(ImageIo, PngRoundsToEightBits) {
    ImageF image{
        4, 1, 3, {0, 0.5f, 1, 1.5f, -1, std::nanf(""), 0.2f, 0.4f, 0.6f, 1, 1, 1}, {{"technique", "drm"}}};
    const fs::path path = folder.path() / "a.PNG";
    write_image(path, image);
    const ImageF back = read_image(path);
    ASSERT_EQ(back.channels, 3);
    const std::vector<int> expected = {0, 128, 255, 255, 0, 0, 51, 102, 153, 255, 255, 255};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(std::lround(back.pixels[i] * 255), expected[i]) << i;
    }
    EXPECT_EQ(back.metadata, image.metadata);
}

TEST_F(ImageIo, PngAlphaDoesNotMultiply) {
    const ImageF image{1, 1, 4, {1, 0.2f, 0, 0.4f}, {}};
    write_image(folder.path() / "a.png", image);
    const ImageF back = read_image(folder.path() / "a.png");
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(back.pixels[i], image.pixels[i], 1e-6);
    }
}

TEST_F(ImageIo, HdrIsCloseRelatively) {
    const ImageF image{2, 2, 3, {1, 1, 1, 1000, 900, 800, 0.001f, 0.001f, 0.0009f, 0, 0, 0}, {}};
    write_image(folder.path() / "a.hdr", image);
    const ImageF back = read_image(folder.path() / "a.hdr");
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_NEAR(back.pixels[i], image.pixels[i], 0.01 * image.pixels[i]);
    }
}

TEST_F(ImageIo, BadOutputs) {
    const ImageF image = ramp(2, 2, 3, 0.1f);
    expect_refused(folder.path() / "a.xyz", image, "expected .exr, .png, .hdr, ");
    expect_refused(folder.path() / "a", image, "expected .exr, .png, .hdr, ");
    expect_refused(folder.path() / "none" / "a.png", image, "there is no folder");
    fs::create_directory(folder.path() / "b.png");
    expect_refused(folder.path() / "b.png", image, "not a regular file");
    expect_refused(folder.path() / "a.hdr", ramp(2, 2, 1, 1), "1 channels");
    expect_refused(folder.path() / "a.exr", ImageF{}, "0 x 0");
    EXPECT_EQ(files_left(), 1u) << "something besides b.png stayed";
}

// A failed write leaves the old file as it was.
TEST_F(ImageIo, TheOldFileSurvives) {
    const fs::path path = folder.path() / "a.hdr";
    write_image(path, ramp(2, 2, 3, 1));
    const auto before = fs::file_size(path);
    EXPECT_THROW(write_image(path, ramp(2, 2, 2, 1)), InputError);
    EXPECT_EQ(fs::file_size(path), before);
}

TEST_F(ImageIo, WritabilityIsToldEarlyAndLeavesNothing) {
    EXPECT_NO_THROW(check_image_writable(folder.path() / "a.exr"));
    EXPECT_EQ(files_left(), 0u);
    EXPECT_THROW(check_image_writable(folder.path() / "a.psd"), InputError);
    EXPECT_THROW(check_image_writable(folder.path() / "none" / "a.exr"), InputError);
    EXPECT_THROW(check_image_writable(folder.path()), InputError);
    EXPECT_THROW(check_image_writable(""), InputError);
}

// By content, whatever the name says.
TEST_F(ImageIo, ReadsPngJpegAndWebpAsTheyAreStored) {
    const ImageF deep = read_image(folder.write("deep.exr", make_png16(2, 1, {65535, 0, 257, 12345}, 2)));
    EXPECT_EQ(deep.channels, 2);
    EXPECT_EQ(deep.width, 2);
    EXPECT_FLOAT_EQ(deep.pixels[0], 1);
    EXPECT_FLOAT_EQ(deep.pixels[3], 12345.0f / 65535);

    const ImageF palette =
        read_image(folder.write("palette.png", make_palette_png(1, 1, {1}, 4, {0, 0, 0, 255, 0, 51}, {})));
    EXPECT_EQ(palette.channels, 3);
    EXPECT_FLOAT_EQ(palette.pixels[2], 0.2f);

    const ImageF jpeg =
        read_image(folder.write("a.png", make_jpeg(9, 5, std::vector<std::uint8_t>(135, 102), 3)));
    EXPECT_EQ(jpeg.width, 9);
    EXPECT_EQ(jpeg.height, 5);
    EXPECT_EQ(jpeg.channels, 3);
    EXPECT_NEAR(jpeg.pixels[7], 0.4f, 1.1f / 255);

    const ImageF webp = read_image(folder.write("a", make_webp(1, 1, {255, 0, 51, 102}, 4)));
    EXPECT_EQ(webp.channels, 4);
    EXPECT_FLOAT_EQ(webp.pixels[0], 1);
    EXPECT_FLOAT_EQ(webp.pixels[3], 0.4f);
}

// Each beginning of each kind of file; half a JPEG is fine for a texture, but is not the image.
TEST_F(ImageIo, CutFilesAreRefused) {
    std::vector<std::string> files = {make_jpeg(40, 40, std::vector<std::uint8_t>(4800, 90), 3)};
    for (const char* name : {"whole.png", "whole.exr", "whole.hdr"}) {
        write_image(folder.path() / name, ramp(24, 20, 3, 0.01f));
        std::ifstream stream(folder.path() / name, std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    for (const std::string& file : files) {
        for (std::size_t size = 0; size + 3 < file.size(); size += 1 + file.size() / 50) {
            const fs::path cut = folder.write("cut", file.substr(0, size));
            EXPECT_THROW(read_image(cut), InputError) << size << " of " << file.size();
        }
    }
}

// Of a texture no more than 16384 a side are wanted; an image is as it is.
TEST_F(ImageIo, AWideJpegIsNotScaledDown) {
    const ImageF wide =
        read_image(folder.write("wide.jpg", make_jpeg(20000, 2, std::vector<std::uint8_t>(40000, 102), 1)));
    EXPECT_EQ(wide.width, 20000);
    EXPECT_EQ(wide.height, 2);
    EXPECT_NEAR(wide.pixels.back(), 0.4f, 1.1f / 255);
}

TEST_F(ImageIo, ACutJpegSaysSo) {
    const std::string file = make_jpeg(40, 40, std::vector<std::uint8_t>(4800, 90), 3);
    const fs::path path = folder.write("cut.jpg", file.substr(0, file.size() - 10));
    try {
        read_image(path);
        ADD_FAILURE() << "read";
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with("cannot be read to its end: the file is cut off"))
            << error.what();
    }
}

TEST_F(ImageIo, PngKeepsTextsOfOtherAlphabets) {
    ImageF image = ramp(2, 2, 3, 0.1f);
    image.metadata = {{"scene",
                       "Stra\xc3\x9f"
                       "e"},
                      {"settings", std::string(100000, 'x')}};
    write_image(folder.path() / "a.png", image);
    EXPECT_EQ(read_image(folder.path() / "a.png").metadata, image.metadata);
}

TEST_F(ImageIo, BadInputs) {
    EXPECT_THROW(read_image(folder.path() / "none.png"), InputError);
    EXPECT_THROW(read_image(folder.path()), InputError);
    for (const char* name : {"a.png", "a.exr", "a.hdr", "a.xyz"}) {
        EXPECT_THROW(read_image(folder.write(name, "")), InputError) << name;
        EXPECT_THROW(read_image(folder.write(name, "this is no image")), InputError) << name;
    }
    write_image(folder.path() / "whole.exr", ramp(64, 64, 3, 1));
    std::ifstream stream(folder.path() / "whole.exr", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_THROW(read_image(folder.write("cut.exr", bytes.substr(0, bytes.size() / 2))), InputError);
}

}  // namespace
}  // namespace lanthorn
