#include "game/session.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "lanthorn/core/error.h"
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
            LANTHORN_SOURCE_DIR "/assets/lantern-room.glb";  // any file: its hash is what counts here
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
    options.level = LANTHORN_SOURCE_DIR "/assets/cornell.glb";
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
