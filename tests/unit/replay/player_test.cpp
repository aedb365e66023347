#include "lanthorn/replay/player.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "tests/unit/replay/test_header.h"

namespace lanthorn::replay {
namespace {

Recording three_steps() {
    Recording recording{header(), {}, {}};
    for (std::uint8_t i = 0; i < 3; ++i) {
        RecordedStep step{{std::byte(i), std::byte(0), std::byte(1), std::byte(0)}, {}, {10u + i, 20u}};
        if (i == 1) {
            step.sensors.push_back({0, 3, 0.5f});
        }
        recording.steps.push_back(step);
    }
    return recording;
}

TEST(Player, HandsOutWhatWasRecorded) {
    Player player("a.rec", three_steps(), header());
    EXPECT_EQ(player.seed(), 9u);
    for (std::int16_t i = 0; i < 3; ++i) {
        ASSERT_FALSE(player.done());
        EXPECT_EQ(player.input<Input>().walk, i);
        EXPECT_EQ(player.sensors().size(), i == 1 ? 1u : 0u);
        EXPECT_TRUE(player.check(std::vector<std::uint64_t>{10u + unsigned(i), 20u}));
    }
    EXPECT_TRUE(player.done());
    EXPECT_FALSE(player.divergence());
}

TEST(Player, NamesTheFirstStepAndPartThatDiffer) {
    Player player("a.rec", three_steps(), header());
    EXPECT_TRUE(player.check(std::vector<std::uint64_t>{10, 20}));
    EXPECT_FALSE(player.check(std::vector<std::uint64_t>{11, 0xbeef}));
    EXPECT_FALSE(player.check(std::vector<std::uint64_t>{12, 20}));  // equal again, but diverged before
    ASSERT_TRUE(player.divergence());
    EXPECT_EQ(player.divergence()->step, 1u);
    EXPECT_EQ(player.divergence()->part, "player");
    EXPECT_EQ(player.divergence()->describe(),
              "step 1: player: expected hash 0000000000000014, found 000000000000beef");
}

TEST(Player, RefusesWhatWasRecordedWithSomethingElse) {
    const auto refused = [](auto alter) {
        RecordingHeader mine = header();
        alter(mine);
        EXPECT_THROW(Player("a.rec", three_steps(), mine), InputError);
    };
    refused([](RecordingHeader& h) { h.level = "other.glb"; });
    refused([](RecordingHeader& h) { h.level_hash = 6; });
    refused([](RecordingHeader& h) { h.step_rate = 30; });
    refused([](RecordingHeader& h) { h.input_format = "test-2"; });
    refused([](RecordingHeader& h) { h.input_size = 8; });
    refused([](RecordingHeader& h) { h.parts = {"door"}; });
    refused([](RecordingHeader& h) { h.sensors = {}; });

    RecordingHeader other_build = header();
    other_build.build = "elsewhere";
    other_build.seed = 1;
    EXPECT_NO_THROW(Player("a.rec", three_steps(), other_build));
}

}  // namespace
}  // namespace lanthorn::replay
