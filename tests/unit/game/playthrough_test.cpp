#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "engine/build_info/build_info.h"
#include "game/presentation/tour.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/recording.h"
#include "lanthorn/scene/light_sensor.h"
#include "tests/support/repository.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

namespace fs = std::filesystem;

class PlaythroughFile : public testing::Test {
  protected:
    PlaythroughFile()
        : file_(fs::temp_directory_path() / ("lanthorn-playthrough-" + std::to_string(::getpid()) + ".rec")) {
        options_.headless = true;
        options_.level =
            support::repository_file("assets/lantern-room.glb");  // any file: its hash is what counts here
        options_.threads = 1;
    }
    ~PlaythroughFile() override { fs::remove(file_); }

    void record() {
        Options options = options_;
        options.record = file_.string();
        options.seed = 5;
        Playthrough playthrough(options, test_level().scene);
        session::Session& session = playthrough.session();
        while (!session.done()) {
            session.app().step();
        }
        session.finish();
    }
    Options replaying() const {
        Options options = options_;
        options.replay = file_.string();
        return options;
    }

    fs::path file_;
    Options options_;
};

TEST_F(PlaythroughFile, SaysWhichCommitRecordedIt) {
    record();
    const std::string build = replay::read_recording(file_.string()).header.build;
    EXPECT_EQ(build, std::string(kVersion) + ' ' + kCommit + ' ' + kBuildType);
}

TEST_F(PlaythroughFile, AReplayIsWhatWasRecorded) {
    record();
    for (const int threads : {1, 2}) {
        Options options = replaying();
        options.threads = threads;
        Playthrough playthrough(options, test_level().scene);
        session::Session& session = playthrough.session();
        EXPECT_EQ(session.length(), Tour::kSteps);
        while (!session.done()) {
            session.app().step();
        }
        EXPECT_EQ(session.divergence(), "");
        EXPECT_EQ(session.app().world().get<Door>(find_by_name(session.app().world(), "door")).angle, 1.9);
    }
}

TEST_F(PlaythroughFile, ADifferentGameIsFoundOut) {
    record();
    scene_generator::Builder altered = test_level();
    for (NodeData& node : altered.scene.nodes) {
        if (node.name == "door") {
            node.extras = R"({"door":{"open_angle":1.8},"body":{"type":"kinematic"}})";
        }
    }
    Playthrough playthrough(replaying(), altered.scene);
    session::Session& session = playthrough.session();
    while (!session.done()) {
        session.app().step();
    }
    EXPECT_EQ(session.divergence().substr(0, 14), "step 0: door: ");
}

// On replay the recorded readings drive the game, and fresh ones are held against them.
TEST_F(PlaythroughFile, ReplaysTheReadingsOfSensors) {
    const auto play = [](session::Session& session, float lux) {
        while (!session.done()) {
            if (session.steps() % 60 == 0 && lux > 0) {
                ecs::World& world = session.app().world();
                world.resource_mut<SensorInbox>().samples = {
                    {find_by_name(world, "far").index, session.steps() - session.steps() / 60, lux}};
            }
            session.app().step();
        }
        return session.app().world().get<Goal>(find_by_name(session.app().world(), "far")).reached;
    };
    {
        Options options = options_;
        options.record = file_.string();
        Playthrough playthrough(options, test_level().scene);
        session::Session& session = playthrough.session();
        EXPECT_TRUE(play(session, 2.5f));
        session.finish();
    }
    for (const float fresh : {0.0f, 2.6f}) {
        Playthrough playthrough(replaying(), test_level().scene);
        session::Session& session = playthrough.session();
        EXPECT_TRUE(play(session, fresh)) << fresh;
        EXPECT_EQ(session.divergence(), "");
    }
    Playthrough playthrough(replaying(), test_level().scene);
    session::Session& session = playthrough.session();
    EXPECT_TRUE(play(session, 0.5f));
    EXPECT_NE(session.divergence().find("sensor far: read 0.5, recorded 2.5 to 2.5"), std::string::npos)
        << session.divergence();
}

TEST_F(PlaythroughFile, AnotherLevelIsRefused) {
    record();
    Options options = replaying();
    options.level = support::repository_file("assets/cornell.glb");
    EXPECT_THROW(Playthrough(options, test_level().scene), InputError);
}

TEST_F(PlaythroughFile, LivePlayHasNoEnd) {
    Options options = options_;
    options.headless = false;
    Playthrough playthrough(options, test_level().scene);
    session::Session& session = playthrough.session();
    EXPECT_FALSE(session.length());
    session.app().step();
    EXPECT_FALSE(session.done());
}

}  // namespace
}  // namespace lanthorn::game
