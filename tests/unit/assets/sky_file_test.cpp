#include "lanthorn/assets/sky_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

class SkyFile : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("lanthorn-sky-" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    static ImageF image(int width, int height, int channels, float value) {
        return {width,
                height,
                channels,
                std::vector<float>(static_cast<std::size_t>(width * height * channels), value),
                {}};
    }
    fs::path write(const std::string& name, const ImageF& image) {
        write_image(folder_ / name, image);
        return folder_ / name;
    }
    // The line that refuses the file.
    static std::string refusal(const fs::path& path) {
        std::vector<SkySun> suns;
        try {
            read_sky(path, suns);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_;
};

TEST_F(SkyFile, IsReadInNitsFromTheZenithDown) {
    ImageF sky = image(8, 4, 3, 0.25f);
    sky.at(2, 0, 1) = 700;
    std::vector<SkySun> suns;
    for (const char* name : {"sky.exr", "sky.hdr"}) {
        const Sky read = read_sky(write(name, sky), suns);
        ASSERT_TRUE(read.image);
        EXPECT_EQ(read.image->width, 8u);
        EXPECT_NEAR(read.image->at(2, 0).y, 700, 4);
        EXPECT_NEAR(read.image->at(7, 3).x, 0.25, 2e-3);
        EXPECT_FALSE(read.light) << "too coarse for suns: the same image lights the scene";
        EXPECT_TRUE(suns.empty());
    }
}

TEST_F(SkyFile, HasItsSunTakenOutOfTheLightAlone) {
    ImageF sky = image(128, 64, 3, 100);
    for (int c = 0; c < 3; ++c) {
        sky.at(40, 20, c) = 1e8f;
    }
    std::vector<SkySun> suns;
    const Sky read = read_sky(write("sun.exr", sky), suns);
    ASSERT_EQ(suns.size(), 1u);
    ASSERT_TRUE(read.light);
    EXPECT_NEAR(read.image->at(40, 20).x, 1e8f, 1e2f) << "the camera sees it";
    EXPECT_LT(read.light->at(40, 20).x, 1000);
}

// As those around them, whose middle one a neighbour that is far brighter does not change; one line tells of
// all.
TEST_F(SkyFile, PixelsThatAreNoRadianceAreMended) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, -3.0f}) {
        ImageF bad = image(8, 4, 3, 2);
        bad.at(0, 2, 0) = value;
        bad.at(1, 2, 2) = value;
        bad.at(7, 1, 0) = 1e6f;
        bad.at(4, 0, 1) = value;
        std::vector<SkySun> suns;
        std::string note;
        const Sky sky = read_sky(write("bad.exr", bad), suns, &note);
        EXPECT_EQ(sky.image->at(0, 2), vec3(2)) << value;
        EXPECT_EQ(sky.image->at(1, 2), vec3(2)) << value;
        EXPECT_EQ(sky.image->at(4, 0), vec3(2)) << value;
        EXPECT_EQ(sky.image->at(7, 1).x, 1e6f) << "sound";
        EXPECT_NE(note.find("bad.exr: 3 pixels are negative, infinite or no number"), std::string::npos)
            << note;
    }
    std::vector<SkySun> suns;
    std::string note;
    const Sky none = read_sky(write("none.exr", image(8, 4, 3, -1)), suns, &note);
    EXPECT_EQ(none.image->at(3, 3), vec3(0)) << "nothing sound around";
    note.clear();
    read_sky(write("sound.exr", image(8, 4, 3, 1)), suns, &note);
    EXPECT_EQ(note, "");
}

TEST_F(SkyFile, RefusesWhatIsNoSkyInOneLine) {
    EXPECT_NE(refusal(folder_ / "none.hdr").find("no such file"), std::string::npos);
    std::ofstream(folder_ / "text.hdr") << "this is no image";
    EXPECT_NE(refusal(folder_ / "text.hdr").find("text.hdr"), std::string::npos);
    EXPECT_NE(refusal(write("square-and-more.exr", image(4, 8, 3, 1))).find("found 4 x 8 pixels"),
              std::string::npos);
    const fs::path whole = write("whole.exr", image(64, 32, 3, 1));
    fs::resize_file(whole, fs::file_size(whole) / 2);
    const std::string cut = refusal(whole);
    EXPECT_NE(cut.find("whole.exr"), std::string::npos);
    EXPECT_EQ(cut.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace lanthorn
