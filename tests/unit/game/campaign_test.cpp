// The levels of the campaign: their files are there, and say what they are called.
#include "game/campaign.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/glb_bytes.h"

namespace lanthorn::game {
namespace {

TEST(Campaign, EveryLevelHasATitleAndHints) {
    ASSERT_FALSE(campaign().empty());
    for (const std::string_view stem : campaign()) {
        const LevelInfo info = read_level_info(level_path(stem));
        EXPECT_FALSE(info.title.empty()) << stem;
        EXPECT_GE(info.hints.size(), 2u) << stem;
    }
}

class LevelFile : public testing::Test {
  protected:
    void write(const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }
    std::string refusal() {
        try {
            read_level_info(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    ~LevelFile() override { std::remove(path.c_str()); }
    const std::string path = testing::TempDir() + "campaign-level.glb";
};

TEST_F(LevelFile, ThatSaysNothingIsCalledNothing) {
    write(scene_generator::glb_bytes(test_level().scene));
    EXPECT_EQ(read_level_info(path), LevelInfo());
}

TEST_F(LevelFile, SaysItsTitle) {
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("level", {})].extras =
        R"({"level":{"title":"A test","hints":["One","Two"]}})";
    write(scene_generator::glb_bytes(level.scene));
    EXPECT_EQ(read_level_info(path).title, "A test");
    EXPECT_EQ(read_level_info(path).hints, (std::vector<std::string>{"One", "Two"}));
}

TEST_F(LevelFile, ThatIsDamagedIsRefusedByName) {
    EXPECT_EQ(refusal(), path + ": cannot be opened");
    write("a text");
    EXPECT_EQ(refusal(), path + ": beginning: is not binary glTF");
    const std::string whole = scene_generator::glb_bytes(test_level().scene);
    write(whole.substr(0, 200));
    EXPECT_EQ(refusal(), path + ": first chunk: is cut off");
    std::string spoilt = whole;
    spoilt[20] = '!';
    write(spoilt);
    EXPECT_EQ(refusal(), path + ": first chunk: is not JSON");
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("about", {})].extras = R"({"level":{"title":5}})";
    write(scene_generator::glb_bytes(level.scene));
    EXPECT_NE(refusal().find("node 'about'"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace lanthorn::game
