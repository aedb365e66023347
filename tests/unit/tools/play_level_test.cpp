// A scene that is played from where the editor looks: what the game gets.
#include "tools/lanthorn/edit/play_level.h"

#include <gtest/gtest.h>

#include "game/rules/components.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::tools {
namespace {

editor::SessionOptions with_game() {
    editor::SessionOptions options;
    options.view.declare = game::declare_components;
    return options;
}

// Where the node stands in the written level, and which way it looks.
void expect_looks(editor::EditSession& session, const std::string& eyes, const workbench::CameraPose& pose) {
    const testing_tools::TemporaryFolder folder;
    play_document(session).write(folder.path("level.glb"));
    editor::EditSession played(with_game());
    played.open(folder.path("level.glb"));
    const dmat4 world = played.model().world_matrix(played.node_at(eyes));
    const Transform expected = workbench::transform_of(pose);
    EXPECT_LT(glm::length(dvec3(world[3]) - expected.translation), 1e-4);
    const dvec3 ahead = glm::dquat(expected.rotation) * dvec3(0, 0, -1);
    EXPECT_LT(glm::length(-glm::normalize(dvec3(world[2])) - ahead), 1e-4);
}

TEST(PlayLevel, ThePlayerStandsWhereTheEditorLooksFrom) {
    editor::EditSession session(with_game());
    session.open(support::repository_file("assets/levels/shutter.glb"));
    const std::string before = session.document().json_text();
    const workbench::CameraPose pose{{0.4, 1.9, -0.7}, 130, -12, 60};
    session.set_pose(pose);
    session.run("add-light / lamp point 0 1.5 0");  // unsaved edits are played
    expect_looks(session, "/player/player-eyes", pose);
    const GltfDocument played = play_document(session);
    EXPECT_NE(played.json_text().find("\"lamp\""), std::string::npos);
    session.undo();
    EXPECT_EQ(session.document().json_text(), before);
}

// Whoever opens a house walks in it.
TEST(PlayLevel, ASceneWithoutAPlayerGetsOneAndGroundToStandOn) {
    editor::EditSession session(with_game());
    session.new_room();
    const workbench::CameraPose pose{{1, 1.7, 0.5}, -40, 5, 60};
    session.set_pose(pose);
    expect_looks(session, "/player/player-eyes", pose);
    const GltfDocument played = play_document(session);
    int solid = 0;
    for (std::size_t node = 0; node < played.node_count(); ++node) {
        solid += played.extras(node).find("collider") != std::string::npos ? 1 : 0;
    }
    EXPECT_GE(solid, 6);
    EXPECT_EQ(session.document().json_text().find("collider"), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::tools
