// The recorded session of opening the door: every state as recorded, on any number of threads.
#include <gtest/gtest.h>

#include "game/session.h"
#include "lanthorn/assets/gltf_import.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

Options replaying() {
    Options options;
    options.headless = true;
    options.level = support::repository_file("assets/lantern-room.glb");
    options.replay = support::repository_file("tests/replay/open-the-door.rec");
    return options;
}

class OpenTheDoor : public testing::TestWithParam<int> {};

TEST_P(OpenTheDoor, EveryStateIsAsRecorded) {
    Options options = replaying();
    options.threads = GetParam();
    const Level level = find_level(import_gltf(options.level));
    Session session(options, level);
    ASSERT_GT(*session.length(), 300u);
    double widest = 0;
    while (!session.done()) {
        session.step();
        widest = std::max(widest, session.view().door_angle);
    }
    EXPECT_FALSE(session.divergence()) << session.divergence()->describe();
    // It is the session it is meant to be: the door was opened and gone through.
    EXPECT_EQ(widest, level.door->open_angle);
    EXPECT_GT(session.view().eye.x, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Threads, OpenTheDoor, testing::Values(1, 2, 0));

TEST(OpenTheDoorAltered, IsFoundOutAtTheStep) {
    const Options options = replaying();
    const Level level = find_level(import_gltf(options.level));
    replay::Recording recording = replay::read_recording(options.replay);
    // One bit of one input: the last digit of the 100th step's turn.
    recording.steps[100].input[4] ^= std::byte{1};
    const std::string file = testing::TempDir() + "altered.rec";
    replay::write_recording(file, recording);
    Options altered = options;
    altered.replay = file;
    Session session(altered, level);
    while (!session.done()) session.step();
    ASSERT_TRUE(session.divergence());
    EXPECT_EQ(session.divergence()->step, 100u);
    EXPECT_EQ(session.divergence()->part, "player");
    std::remove(file.c_str());
}

}  // namespace
}  // namespace lanthorn::game
