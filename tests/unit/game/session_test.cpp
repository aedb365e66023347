#include "game/session.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "lanthorn/core/error.h"
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
        Session session(options, test_level());
        while (!session.done()) session.step();
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

TEST_F(SessionFile, AReplayIsWhatWasRecorded) {
    record();
    for (const int threads : {1, 2}) {
        Options options = replaying();
        options.threads = threads;
        Session session(options, test_level());
        EXPECT_EQ(session.length(), Tour::kSteps);
        while (!session.done()) session.step();
        EXPECT_FALSE(session.divergence()) << session.divergence()->describe();
        EXPECT_EQ(session.view().door_angle, 1.9);
    }
}

TEST_F(SessionFile, AKilledGameIsReplayedUpToItsLastSecond) {
    constexpr int kSteps = 200;
    Options options = options_;
    options.record = file_.string();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        Session session(options, test_level());
        for (int i = 0; i < kSteps; ++i) {
            session.step();
        }
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);

    testing::internal::CaptureStderr();
    Session session(replaying(), test_level());
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("cut off at byte"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
    while (!session.done()) session.step();
    EXPECT_GT(session.steps(), kSteps - 60u);
    EXPECT_FALSE(session.divergence()) << session.divergence()->describe();
}

TEST_F(SessionFile, PlaysOnWhereTheDiskIsFull) {
    Options options = options_;
    options.record = file_.string();
    testing::internal::CaptureStderr();
    {
        const support::FileSizeLimit limit(10000);
        Session session(options, test_level());
        while (!session.done()) session.step();
        session.finish();
        EXPECT_TRUE(session.recording_failed());
        EXPECT_EQ(session.steps(), Tour::kSteps);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    Session replayed(replaying(), test_level());
    EXPECT_GT(*replayed.length(), 60u);
    while (!replayed.done()) replayed.step();
    EXPECT_FALSE(replayed.divergence());
}

TEST_F(SessionFile, ADifferentGameIsFoundOut) {
    record();
    Level altered = test_level();
    altered.door->open_angle = 1.8;
    Session session(replaying(), altered);
    while (!session.done()) session.step();
    ASSERT_TRUE(session.divergence());
    // The first step that knows where the door goes.
    EXPECT_EQ(session.divergence()->step, Tour::kDoorStep);
    EXPECT_EQ(session.divergence()->part, "door");
}

TEST_F(SessionFile, AnotherLevelIsRefused) {
    record();
    Options options = replaying();
    options.level = support::repository_file("assets/cornell.glb");
    EXPECT_THROW(Session(options, test_level()), InputError);
}

TEST_F(SessionFile, SaysAtOnceThatItCannotRecord) {
    Options options = options_;
    options.record = "/no/such/folder/a.rec";
    EXPECT_THROW(Session(options, test_level()), InputError);
}

TEST_F(SessionFile, LivePlayHasNoEnd) {
    Options options = options_;
    options.headless = false;
    Session session(options, test_level());
    EXPECT_EQ(session.driver(), Driver::devices);
    EXPECT_FALSE(session.length());
    session.step({});
    EXPECT_FALSE(session.done());
}

}  // namespace
}  // namespace lanthorn::game
