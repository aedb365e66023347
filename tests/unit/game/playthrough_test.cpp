#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/recording.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/repository.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

namespace fs = std::filesystem;

class SessionFile : public testing::Test {
  protected:
    SessionFile()
        : file_(fs::temp_directory_path() / ("lanthorn-session-" + std::to_string(::getpid()) + ".rec")) {
        options_.headless = true;
        options_.level =
            support::repository_file("assets/lantern-room.glb");  // any file: its hash is what counts here
        options_.threads = 1;
    }
    ~SessionFile() override { fs::remove(file_); }

    void record() {
        Options options = options_;
        options.record = file_.string();
        options.seed = 5;
        Session session(options, test_level().scene);
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

TEST_F(SessionFile, SaysWhichCommitRecordedIt) {
    record();
    const std::string build = replay::read_recording(file_.string()).header.build;
    EXPECT_EQ(build, std::string(kVersion) + ' ' + kCommit + ' ' + kBuildType);
}

TEST_F(SessionFile, AReplayIsWhatWasRecorded) {
    record();
    for (const int threads : {1, 2}) {
        Options options = replaying();
        options.threads = threads;
        Session session(options, test_level().scene);
        EXPECT_EQ(session.length(), Tour::kSteps);
        while (!session.done()) {
            session.app().step();
        }
        EXPECT_EQ(session.divergence(), "");
        EXPECT_EQ(session.app().world().get<Door>(find_by_name(session.app().world(), "door")).angle, 1.9);
    }
}

TEST_F(SessionFile, AKilledGameIsReplayedUpToItsLastSecond) {
    constexpr int kSteps = 200;
    Options options = options_;
    options.record = file_.string();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        Session session(options, test_level().scene);
        for (int i = 0; i < kSteps; ++i) {
            session.app().step();
        }
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);

    testing::internal::CaptureStderr();
    Session session(replaying(), test_level().scene);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("cut off at byte"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
    while (!session.done()) {
        session.app().step();
    }
    EXPECT_GT(session.steps(), kSteps - 60u);
    EXPECT_EQ(session.divergence(), "");
}

TEST_F(SessionFile, PlaysOnWhereTheDiskIsFull) {
    Options options = options_;
    options.record = file_.string();
    testing::internal::CaptureStderr();
    {
        const support::FileSizeLimit limit(40000);
        Session session(options, test_level().scene);
        while (!session.done()) {
            session.app().step();
        }
        session.finish();
        EXPECT_TRUE(session.recording_failed());
        EXPECT_EQ(session.steps(), Tour::kSteps);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    Session replayed(replaying(), test_level().scene);
    EXPECT_GT(*replayed.length(), 60u);
    while (!replayed.done()) {
        replayed.app().step();
    }
    EXPECT_EQ(replayed.divergence(), "");
}

TEST_F(SessionFile, ADifferentGameIsFoundOut) {
    record();
    scene_generator::Builder altered = test_level();
    for (NodeData& node : altered.scene.nodes) {
        if (node.name == "door") {
            node.extras = R"({"door":{"open_angle":1.8},"body":{"type":"kinematic"}})";
        }
    }
    Session session(replaying(), altered.scene);
    while (!session.done()) {
        session.app().step();
    }
    EXPECT_EQ(session.divergence().substr(0, 14), "step 0: door: ");
}

// On replay the recorded readings drive the game, and fresh ones are held against them.
TEST_F(SessionFile, ReplaysTheReadingsOfSensors) {
    const auto play = [](Session& session, float lux) {
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
        Session session(options, test_level().scene);
        EXPECT_TRUE(play(session, 2.5f));
        session.finish();
    }
    for (const float fresh : {0.0f, 2.6f}) {
        Session session(replaying(), test_level().scene);
        EXPECT_TRUE(play(session, fresh)) << fresh;
        EXPECT_EQ(session.divergence(), "");
    }
    Session session(replaying(), test_level().scene);
    EXPECT_TRUE(play(session, 0.5f));
    EXPECT_NE(session.divergence().find("sensor far: read 0.5, recorded 2.5 to 2.5"), std::string::npos)
        << session.divergence();
}

TEST_F(SessionFile, AnotherLevelIsRefused) {
    record();
    Options options = replaying();
    options.level = support::repository_file("assets/cornell.glb");
    EXPECT_THROW(Session(options, test_level().scene), InputError);
}

TEST_F(SessionFile, SaysAtOnceThatItCannotRecord) {
    Options options = options_;
    options.record = "/no/such/folder/a.rec";
    EXPECT_THROW(Session(options, test_level().scene), InputError);
}

TEST_F(SessionFile, LivePlayHasNoEnd) {
    Options options = options_;
    options.headless = false;
    Session session(options, test_level().scene);
    EXPECT_EQ(session.driver(), Driver::devices);
    EXPECT_FALSE(session.length());
    session.app().step();
    EXPECT_FALSE(session.done());
}

}  // namespace
}  // namespace lanthorn::game
