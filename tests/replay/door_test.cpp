// The recorded session of opening the door: every state as recorded, on any number of threads.
#include <gtest/gtest.h>

#include "game/presentation/playthrough.h"
#include "game/rules/components.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
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
    Playthrough playthrough(options, import_gltf(options.level));
    session::Session& session = playthrough.session();
    const ecs::World& world = session.app().world();
    const ecs::Entity door = find_by_name(session.app().world(), "door");
    ASSERT_GT(*session.length(), 300u);
    double widest = 0;
    while (!session.done()) {
        session.app().step();
        widest = std::max(widest, world.get<Door>(door).angle);
    }
    EXPECT_EQ(session.divergence(), "");
    // It is the session it is meant to be: the door was opened and gone through, and the far room is lit.
    EXPECT_EQ(widest, world.get<Door>(door).open_angle);
    EXPECT_GT(world.get<LocalTransform>(find_by_name(session.app().world(), "player")).value.translation.x,
              1.0);
    EXPECT_TRUE(world.get<Goal>(find_by_name(session.app().world(), "far_sensor")).reached);
}

INSTANTIATE_TEST_SUITE_P(Threads, OpenTheDoor, testing::Values(1, 2, 0));

TEST(OpenTheDoorAltered, IsFoundOutAtTheStep) {
    const Options options = replaying();
    replay::Recording recording = replay::read_recording(options.replay);
    // One bit of one input: the last digit of the 100th step's turn.
    recording.steps[100].input[4] ^= std::byte{1};
    const std::string file = testing::TempDir() + "altered.rec";
    replay::write_recording(file, recording);
    Options altered = options;
    altered.replay = file;
    Playthrough playthrough(altered, import_gltf(options.level));
    session::Session& session = playthrough.session();
    while (!session.done()) {
        session.app().step();
    }
    EXPECT_EQ(session.divergence().substr(0, 10), "step 100: ");
    std::remove(file.c_str());
}

}  // namespace
}  // namespace lanthorn::game
