// Saving: what was not edited keeps its bytes, and a file appears whole or not at all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/editor/random_commands.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/node_value.h"

namespace lanthorn::editor {
namespace {

using testing_tools::file_bytes;
using testing_tools::TemporaryFolder;

// Of another program's hand: odd spelling, order, white space, extensions and extras that nobody here knows.
constexpr const char* kForeign = R"({
  "asset" : { "version" : "2.0", "generator" : "by hand" , "extras": {"a":1.50} },
  "extensionsUsed" : ["KHR_lights_punctual", "ACME_moss"],
  "scene": 0, "scenes": [ { "nodes": [ 1, 0 ], "name": "s" } ],
  "nodes": [
    { "name":"lamp", "translation":[ 1.0, 2.50, -0.000 ], "extensions":{ "ACME_moss":{"green":1e0}, "KHR_lights_punctual":{"light":0}},
      "extras" : { "zeta": 1, "alpha": [ 1.10, "ü" ], "moss": {"depth": 3.0} } },
    { "mesh":0, "name":"wall", "rotation":[0,0,0,1] }
  ],
  "extensions": { "KHR_lights_punctual": { "lights": [ { "type": "point", "intensity": 65.00 } ] } },
  "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 } } ] } ],
  "accessors": [ { "bufferView":0, "componentType":5126, "count":3, "type":"VEC3", "min":[0,0,0], "max":[1,1,0] } ],
  "bufferViews": [ { "buffer":0, "byteLength":36 } ],
  "buffers": [ { "byteLength":36, "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA" } ]
}
)";

class Save : public testing::Test {
  protected:
    std::string foreign() {
        std::ofstream(folder.path("foreign.gltf"), std::ios::binary) << kForeign;
        return folder.path("foreign.gltf");
    }
    TemporaryFolder folder;
    EditSession session;
};

TEST_F(Save, OpenAndSaveGivesTheSameBytes) {
    session.open(foreign());
    session.save();
    EXPECT_EQ(file_bytes(folder.path("foreign.gltf")), kForeign);
    for (const std::string name : {"assets/levels/pool.glb", "assets/nave.glb", "assets/puppet.glb"}) {
        session.open(support::repository_file(name));
        session.save(folder.path("copy.glb"));
        EXPECT_EQ(file_bytes(folder.path("copy.glb")), file_bytes(support::repository_file(name))) << name;
    }
}

TEST_F(Save, OneMovedLightIsOneTranslation) {
    session.open(foreign());
    session.run("move /lamp 1 3 0");
    const TextChanges changes = session.changes();
    EXPECT_EQ(changes.changed_lines, 1u);
    session.save();
    std::string expected = kForeign;
    const std::string old = "[ 1.0, 2.50, -0.000 ]";
    expected.replace(expected.find(old), old.size(), "[1.0,3.0,0.0]");
    EXPECT_EQ(file_bytes(folder.path("foreign.gltf")), expected);
    EXPECT_FALSE(session.is_dirty());
}

TEST_F(Save, WhatOtherProgramsKeepStays) {
    session.open(foreign());
    EXPECT_EQ(node_value(session.model(), session.registry(), session.node_at("/lamp"), "extras.moss"),
              R"({"depth":3.0})");
    session.run("set /lamp light_sensor.radius 0.5");
    session.run("set /lamp extras.moss {\"depth\":4}");
    session.run("set /lamp light.intensity 70");
    session.run("rename /wall \"north wall\"");
    session.run("undo");
    session.save();
    const std::string now = file_bytes(folder.path("foreign.gltf"));
    for (const char* kept :
         {R"("zeta": 1, "alpha": [ 1.10, "ü" ])", R"("ACME_moss":{"green":1e0})", R"("a":1.50)",
          R"("scenes": [ { "nodes": [ 1, 0 ], "name": "s" } ])", R"("name":"wall")"}) {
        EXPECT_NE(now.find(kept), std::string::npos) << kept << "\n" << now;
    }
    EXPECT_NE(now.find(R"("light_sensor": {"radius":0.5})"), std::string::npos) << now;
}

TEST_F(Save, AFullDiskLeavesTheFileAsItWas) {
    session.open(foreign());
    session.run("move /lamp 1 3 0");
    {
        const support::FileSizeLimit limit(100);
        EXPECT_THROW(session.save(), InputError);
    }
    EXPECT_EQ(file_bytes(folder.path("foreign.gltf")), kForeign);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"foreign.gltf"});
    EXPECT_TRUE(session.is_dirty());
    EXPECT_TRUE(session.can_undo());
    EXPECT_THROW(session.save("/dev/full.glb/x.glb"), InputError);
    session.save();
    EXPECT_FALSE(session.is_dirty());
}

TEST_F(Save, ADeletedFileIsWrittenAgain) {
    session.open(foreign());
    session.run("move /lamp 1 3 0");
    std::filesystem::remove(folder.path("foreign.gltf"));
    EXPECT_TRUE(session.changed_outside());
    EXPECT_THROW(session.reload(), InputError);
    EXPECT_EQ(session.steps().position(), 1u);
    session.save();
    EXPECT_FALSE(session.changed_outside());
    EditSession again;
    again.open(folder.path("foreign.gltf"));
    EXPECT_EQ(node_value(again.model(), again.registry(), again.node_at("/lamp"), "translation"), "[1,3,0]");
}

// The game reads what is shown, to the last bit; some rotations would take turns with another one.
TEST(WrittenRotation, IsReadAsItIs) {
    const auto read = [](const quat& rotation) {
        const auto number = [](float value) {
            return std::strtod(fmt::format("{}", value).c_str(), nullptr);
        };
        const glm::dquat q(number(rotation.w), number(rotation.x), number(rotation.y), number(rotation.z));
        return quat(q / glm::length(q));
    };
    const quat taking_turns(0.5137365f, 0.053189453f, -0.8517448f, 0.08818506f);
    EXPECT_EQ(read(written_rotation(taking_turns)), written_rotation(taking_turns));
    testing_tools::Dice dice(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto part = [&] { return static_cast<float>(dice.between(-1, 1)); };
        const quat rotation = glm::normalize(quat(part(), part(), part(), part()));
        const quat written = written_rotation(rotation);
        ASSERT_EQ(read(written), written) << i;
        ASSERT_LT(glm::length(written - rotation), 1e-6f);
    }
}

TEST_F(Save, ARoomIsSavedAndOpened) {
    session.new_room();
    EXPECT_TRUE(session.is_dirty());
    EXPECT_THROW(session.save(), InputError);
    session.run("move /room/lamp 1 2 0");
    session.save(folder.path("room.glb"));
    EXPECT_FALSE(session.is_dirty());
    EditSession again;
    again.open(folder.path("room.glb"));
    EXPECT_EQ(again.model().node_count(), session.model().node_count());
    EXPECT_EQ(again.notes().size(), 1u);  // it has no camera
}

}  // namespace
}  // namespace lanthorn::editor
