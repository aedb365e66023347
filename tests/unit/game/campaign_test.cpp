// The levels of the campaign: their files are there, and say what they are called.
#include "game/level/campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "game/level/level_files.h"
#include "game/level/story.h"
#include "lanthorn/core/error.h"
#include "tests/support/kept_folder.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/glb_bytes.h"

namespace lanthorn::game {
namespace {

using support::damaged;

TEST(Campaign, EveryLevelHasATitleAndHints) {
    ASSERT_FALSE(campaign().empty());
    for (const std::string_view stem : campaign()) {
        const LevelInfo info = read_level_info(level_path(stem));
        EXPECT_FALSE(info.title.empty()) << stem;
        EXPECT_GE(info.hints.size(), 2u) << stem;
        EXPECT_EQ(std::ranges::count(story_of(stem), '\n'), 1) << stem << " is told in two lines";
    }
}

TEST(Campaign, ItsFilesAreWhereTheEnvironmentSays) {
    const char* set = std::getenv("LANTHORN_ASSETS");
    const std::string before = set != nullptr ? set : "";
    ::setenv("LANTHORN_ASSETS", "/elsewhere", 1);
    EXPECT_EQ(level_path("shutter"), "/elsewhere/levels/shutter.glb");
    const char* program = "lamplighter";
    EXPECT_EQ(parse_options(1, &program).value().level, "/elsewhere/lantern-room.glb");
    set != nullptr ? ::setenv("LANTHORN_ASSETS", before.c_str(), 1) : ::unsetenv("LANTHORN_ASSETS");
}

class FileOfALevel : public support::KeptFolder {
  protected:
    void write(const std::string& bytes) { put(bytes, "level.glb"); }
    std::string refusal() {
        try {
            read_level_info(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    const std::string path = (folder / "level.glb").string();
};

TEST_F(FileOfALevel, ThatSaysNothingIsCalledNothing) {
    write(scene_generator::glb_bytes(test_level().scene));
    EXPECT_EQ(read_level_info(path), LevelInfo());
}

TEST_F(FileOfALevel, ThatNestsTooDeepIsRefused) {
    scene_generator::Builder level = test_level();
    const std::string deep(1'000'000, '[');
    level.scene.nodes[level.node("level", {})].extras = R"({"level":"here"})";
    std::string bytes = scene_generator::glb_bytes(level.scene);
    const std::size_t at = bytes.find("\"here\"");
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 6, deep + std::string(deep.size(), ']'));
    std::uint32_t words = 0;  // of the first chunk
    std::memcpy(&words, &bytes[12], sizeof words);
    words += static_cast<std::uint32_t>(2 * deep.size() - 6);
    std::memcpy(&bytes[12], &words, sizeof words);
    write(bytes);
    EXPECT_NE(refusal().find("found nesting deeper than 64 levels"), std::string::npos) << refusal();
}

TEST_F(FileOfALevel, SaysItsTitle) {
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("level", {})].extras =
        R"({"level":{"title":"A test","hints":["One","Two"]}})";
    write(scene_generator::glb_bytes(level.scene));
    EXPECT_EQ(read_level_info(path).title, "A test");
    EXPECT_EQ(read_level_info(path).hints, (std::vector<std::string>{"One", "Two"}));
}

TEST_F(FileOfALevel, ThatIsDamagedIsRefusedByName) {
    EXPECT_EQ(refusal(), path + ": cannot be opened");
    write("a text");
    EXPECT_EQ(refusal(), path + ": beginning: is not binary glTF");
    const std::string whole = scene_generator::glb_bytes(test_level().scene);
    write(whole.substr(0, 200));
    EXPECT_EQ(refusal(), path + ": first chunk: is cut off");
    std::string spoilt = whole;
    spoilt[20] = '!';
    write(spoilt);
    EXPECT_TRUE(refusal().starts_with(path + ": JSON line 1, column 1: is not JSON")) << refusal();
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("about", {})].extras = R"({"level":{"title":5}})";
    write(scene_generator::glb_bytes(level.scene));
    EXPECT_NE(refusal().find("node 'about'"), std::string::npos) << refusal();
}

// 4 GiB, as head and chunk say together: the file has not got them.
TEST_F(FileOfALevel, IsNoLongerThanItIs) {
    std::string bytes = scene_generator::glb_bytes(test_level().scene);
    bytes.replace(8, 8, 8, '\xff');
    write(bytes);
    EXPECT_EQ(refusal(), path + ": first chunk: is cut off");
}

TEST_F(FileOfALevel, MayHaveNamesThatAreNone) {
    const std::string json = R"({"nodes":[7,{"name":5,"extras":{"level":{"title":5}}}]})";
    const auto word = [](std::size_t value) {
        return std::string{static_cast<char>(value), static_cast<char>(value >> 8), 0, 0};
    };
    write("glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json);
    EXPECT_EQ(refusal().find(path + ": node '': "), 0u) << refusal();
}

// One bad file keeps nobody from the others.
TEST_F(FileOfALevel, ThatIsDamagedIsCalledByItsName) {
    Options options;
    options.straight = true;
    options.level = path;
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("about", {})].extras = R"({"level":{"title":"A test"}})";
    const std::string whole = scene_generator::glb_bytes(level.scene);
    write(whole);
    EXPECT_EQ(level_files(options).front().title, "A test");
    std::mt19937 random(1);
    int spoilt = 0;
    for (int i = 0; i < 300; ++i) {
        write(damaged(whole.substr(0, 4000), random));
        std::string title;
        EXPECT_NO_THROW(title = level_files(options).front().title) << i;
        spoilt += title == "level" ? 1 : 0;
    }
    EXPECT_GT(spoilt, 100);
}

}  // namespace
}  // namespace lanthorn::game
