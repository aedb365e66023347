// What was changed in play, as commands.
#include "tools/editor/core/play_changes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {
namespace {

class PlayChanges : public testing::Test {
  protected:
    PlayChanges() {
        session.new_room();
        session.run("add-node /room shelf 1 0 0");
        session.run("add-node /room/shelf book 0 1 0");
        session.run("rotate /room/shelf 0 90 0");
        session.run("add-node /room walker 0 0 1");
        session.run("set /room/walker extras.player {}");
        session.run("add-node /room/walker hand 0 1 0");
        for (const std::uint32_t node : session.model().in_order()) {
            PlayedNode& played = before[node];
            played.to_world = session.model().world_matrix(node);
            if (const Light* light = light_of(session.model(), node)) {
                played.light = *light;
                played.has_light = true;
            }
        }
        after = before;
    }
    std::uint32_t node(const char* path) const { return session.node_at(path); }
    std::vector<PlayChange> changes(const std::vector<std::uint32_t>& animated = {}) const {
        return play_changes(session.model(), before, after, animated);
    }
    // As one step; what stands otherwise then is where it stood after play.
    void keep(const std::vector<PlayChange>& all) {
        std::vector<std::string> lines;
        for (const PlayChange& change : all) {
            lines.insert(lines.end(), change.lines.begin(), change.lines.end());
        }
        session.run("keep", lines);
        for (const std::uint32_t at : session.model().in_order()) {
            for (int column = 0; column < 4; ++column) {
                for (int row = 0; row < 4; ++row) {
                    EXPECT_NEAR(session.model().world_matrix(at)[column][row],
                                after[at].to_world[column][row], 1e-5)
                        << session.path_of(at);
                }
            }
        }
    }
    // Of a node and all below it, by a motion of the world.
    void move(const char* path, const dmat4& motion) {
        for (auto& [at, played] : after) {
            if (session.model().is_within(at, node(path))) {
                played.to_world = motion * played.to_world;
            }
        }
    }

    EditSession session;
    std::map<std::uint32_t, PlayedNode> before, after;
};

TEST_F(PlayChanges, AreNoneWhereNothingMoved) {
    EXPECT_TRUE(changes().empty());
    move("/room/shelf", glm::translate(dmat4(1), dvec3(0.004, 0, 0)));  // it has settled
    EXPECT_TRUE(changes().empty());
}

TEST_F(PlayChanges, OfWhatCarriesOtherThingsAreItsOwnAlone) {
    move("/room/shelf", glm::translate(dmat4(1), dvec3(3, 0, 0)) *
                            glm::rotate(dmat4(1), glm::radians(40.0), dvec3(0, 1, 0)));
    const std::vector<PlayChange> found = changes();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].node, node("/room/shelf"));
    EXPECT_NE(found[0].title.find("shelf: "), std::string::npos);
    EXPECT_NE(found[0].title.find("turned by 40 degrees"), std::string::npos) << found[0].title;
    keep(found);
}

TEST_F(PlayChanges, OfAThingOnAThingThatMovedAreBoth) {
    move("/room/shelf", glm::translate(dmat4(1), dvec3(3, 0, 0)));
    move("/room/shelf/book", glm::translate(dmat4(1), dvec3(0, -1, 0.5)));
    const std::vector<PlayChange> found = changes();
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].title, "book: 1.1 m away");
    keep(found);
    session.undo();
    EXPECT_EQ(session.model().node(node("/room/shelf")).local.translation, dvec3(1, 0, 0));
}

TEST_F(PlayChanges, OfThePlayerAndOfClipsAreLeftOut) {
    move("/room/walker", glm::translate(dmat4(1), dvec3(3, 0, 0)));
    move("/room/walker/hand", glm::translate(dmat4(1), dvec3(0, 1, 0)));
    move("/room/shelf", glm::translate(dmat4(1), dvec3(0, 2, 0)));
    EXPECT_EQ(changes().size(), 1u);
    EXPECT_TRUE(changes({node("/room/shelf")}).empty());
}

TEST_F(PlayChanges, OfALightAreItsIntensityAndColour) {
    PlayedNode& lamp = after[node("/room/lamp")];
    lamp.light.intensity = 12;
    lamp.light.colour = vec3(1, 0, 0.5f);
    const std::vector<PlayChange> found = changes();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].title, "lamp: gives 12 instead of 80 cd, another colour");
    session.run("keep", found[0].lines);
    EXPECT_EQ(light_of(session.model(), node("/room/lamp"))->intensity, 12);
    EXPECT_EQ(light_of(session.model(), node("/room/lamp"))->colour, vec3(1, 0, 0.5f));
}

}  // namespace
}  // namespace lanthorn::editor
