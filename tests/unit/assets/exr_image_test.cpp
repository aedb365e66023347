// OpenEXR files of other programs: channels, tiles, damage.
#include "engine/assets/exr_image.h"

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <utility>

#include "engine/assets/module_image.h"
#include "tests/unit/assets/image_files.h"
#include "tests/unit/assets/refused_file.h"

namespace lanthorn {
namespace {

ImageF read(const std::string& file) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
    std::optional<ImageF> plain = read_plain_exr("a.exr", bytes);
    return plain ? std::move(*plain) : read_by_module("a.exr", bytes, "openexr");
}

void expect_refused(const std::string& file, const std::string& part) {
    expect_refused_as(
        "a.exr", [&] { read(file); }, part);
}

// Halves hold them exactly.
std::vector<float> eighths(int width, int height, std::size_t channels) {
    std::vector<float> values;
    for (std::size_t i = 0; i < static_cast<std::size_t>(width * height) * channels; ++i) {
        values.push_back(0.125f * static_cast<float>(i % 1000));
    }
    return values;
}

// Of a window that begins elsewhere, in lines and in tiles, higher than what is decoded at once.
TEST(ExrImage, HalvesInLinesAndTiles) {
    for (const ExrKind kind : {ExrKind::lines, ExrKind::tiles}) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(23, 11), std::pair(9, 531)}) {
            const std::vector<float> values = eighths(width, height, 3);
            const ImageF image = read(make_exr(width, height, values, {"R", "G", "B"}, kind));
            EXPECT_EQ(image.width, width);
            EXPECT_EQ(image.height, height);
            EXPECT_EQ(image.channels, 3);
            EXPECT_EQ(image.pixels, values);
        }
    }
}

TEST(ExrImage, ChannelsByName) {
    const auto channels = [](const std::vector<std::string>& names) {
        std::vector<float> values;
        for (std::size_t i = 0; i < names.size(); ++i) {
            values.push_back(static_cast<float>(i));
        }
        return read(make_exr(1, 1, values, names)).pixels;
    };
    using Values = std::vector<float>;
    EXPECT_EQ(channels({"A", "B", "G", "R"}), (Values{3, 2, 1, 0}));
    EXPECT_EQ(channels({"a", "b", "g", "r"}), (Values{3, 2, 1, 0})) << "in small letters";
    EXPECT_EQ(channels({"eye.b", "eye.g", "eye.r", "eye.z"}), (Values{2, 1, 0}));
    EXPECT_EQ(channels({"R", "G", "B", "Z"}), (Values{0, 1, 2})) << "depth is no alpha";
    EXPECT_EQ(channels({"R", "G", "B", "Z", "A"}), (Values{0, 1, 2, 4}));
    EXPECT_EQ(channels({"X", "Y", "Z"}), (Values{0, 1, 2})) << "a normal";
    EXPECT_EQ(channels({"Z"}), (Values{0}));
    EXPECT_EQ(channels({"R", "G", "B", "glossy.R", "glossy.G", "glossy.B"}), (Values{0, 1, 2}));
    EXPECT_EQ(channels({"b.R", "b.G", "b.B", "a.B", "a.G", "a.R"}), (Values{5, 4, 3})) << "the first layer";
    EXPECT_EQ(channels({"1", "2", "3", "4", "5"}), (Values{0, 1, 2, 3}));
}

TEST(ExrImage, WholeNumbersStayWhatTheyAre) {
    const std::vector<float> values = {0, 1, 2, 255, 65536, 4294967040.0f};
    EXPECT_EQ(read(make_exr(3, 2, values, {"id"}, ExrKind::whole_numbers)).pixels, values);
}

TEST(ExrImage, TheSameImageIsTheSameBytes) {
    const ImageF image{4, 3, 3, eighths(4, 3, 3), {{"seed", "7"}}};
    EXPECT_EQ(exr_bytes(image), exr_bytes(image));
}

// Each beginning, and each byte damaged: one line, or an image of its size.
TEST(ExrImage, DamageIsToldOrDoesNoHarm) {
    int refused = 0;
    for (const ExrKind kind : {ExrKind::lines, ExrKind::tiles}) {
        const std::string file = make_exr(19, 40, eighths(19, 40, 3), {"R", "G", "B"}, kind);
        const auto check = [&](const std::string& damaged) {
            try {
                const ImageF image = read(damaged);
                EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width) *
                                                   static_cast<std::size_t>(image.height) *
                                                   static_cast<std::size_t>(image.channels));
            } catch (const InputError& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
                ++refused;
            }
        };
        for (std::size_t i = 0; i < file.size(); i += i < 400 ? 2 : 31) {
            check(file.substr(0, i));
            std::string damaged = file;
            damaged[i] = static_cast<char>(damaged[i] ^ (i % 2 == 0 ? 0xff : 0x41));
            check(damaged);
        }
    }
    EXPECT_GT(refused, 300);
}

class Stated : public testing::Test {
  protected:
    // A number of a header, little-endian, `offset` behind the attribute's name, type and size.
    void state(const std::string& name, const std::string& type, std::size_t offset, std::uint32_t value) {
        const std::string head = name + '\0' + type + '\0';
        const std::size_t at = file.find(head);
        ASSERT_NE(at, std::string::npos) << name;
        for (std::size_t i = 0; i < 4; ++i) {
            file[at + head.size() + 4 + offset + i] = static_cast<char>(value >> (8 * i) & 0xff);
        }
    }
    std::string file = make_exr(8, 8, eighths(8, 8, 1), {"R"});
};

TEST_F(Stated, ALargeImageInAFewBytes) {
    state("dataWindow", "box2i", 8, 16380);
    state("dataWindow", "box2i", 12, 16388);
    expect_refused(file, "cannot be read ");
    state("dataWindow", "box2i", 8, 1 << 29);
    state("dataWindow", "box2i", 12, 1 << 29);
    expect_refused(file, "cannot be read ");
}

TEST_F(Stated, ALongRow) {
    state("dataWindow", "box2i", 8, 1 << 27);
    state("dataWindow", "box2i", 12, 5);
    expect_refused(file, "cannot be read as an image: ");
    state("displayWindow", "box2i", 8, 1 << 27);
    state("displayWindow", "box2i", 12, 5);
    expect_refused(file, "has rows of 536870928 bytes, expected at most 1048576");
}

// The library would make room for it before it looks for it.
TEST_F(Stated, ALongAttribute) {
    state("lineOrder", "lineOrder", std::size_t(0) - 4, 0x7fffffff);
    expect_refused(file, "the file is cut off in its header");
}

// Read as its type says, the rest of the header would begin in its middle.
TEST_F(Stated, AnAttributeOfAnotherSizeThanItsType) {
    const std::size_t at = file.find(std::string("pixelAspectRatio\0float\0", 23));
    ASSERT_NE(at, std::string::npos);
    file[at + 23] = 8;
    file.insert(at + 27, 4, '\1');
    expect_refused(file, "cannot be read as an image: its header is damaged");
}

TEST_F(Stated, AListOfChannelsThatEndsBeforeItsEnd) {
    const std::size_t at = file.find(std::string("chlist\0", 7));
    ASSERT_NE(at, std::string::npos);
    file[at + 7] = static_cast<char>(file[at + 7] + 1);
    file.insert(at + 11, 1, '\0');
    expect_refused(file, "cannot be read as an image: its header is damaged");
}

TEST(ExrImage, NoExr) {
    expect_refused("", "the file is cut off in its header");
    expect_refused("v/1\1", "the file is cut off in its header");
    expect_refused(std::string("v/1\1\2\0\0\0\0", 9), "cannot be read as an image: ");
}

}  // namespace
}  // namespace lanthorn
