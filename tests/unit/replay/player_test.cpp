#include "lanthorn/replay/player.h"

#include <gtest/gtest.h>

#include <functional>

#include "lanthorn/core/error.h"
#include "tests/unit/replay/test_header.h"

namespace lanthorn::replay {
namespace {

using Hashes = std::vector<std::uint64_t>;

// The states of the door: 10, 11, 12, ...; the player's: 20.
Recording recorded(std::size_t steps = 3) {
    Recording recording{header(), {}, {}};
    Hashes before;
    for (std::size_t i = 0; i < steps; ++i) {
        RecordedStep step{{std::byte(i), std::byte(0), std::byte(1), std::byte(0)}, {}};
        if (i == 1) {
            step.sensors.push_back({0, 3, 0.5f});
        }
        mark_state(Hashes{10u + i, 20u}, before, step);
        recording.steps.push_back(step);
    }
    return recording;
}

Player player(const RecordingHeader& mine = header(), std::size_t steps = 3) {
    return Player("a.rec", std::make_shared<Recording>(recorded(steps)), mine);
}

TEST(Player, HandsOutWhatWasRecorded) {
    Player one = player();
    EXPECT_EQ(one.seed(), 9u);
    for (std::int16_t i = 0; i < 3; ++i) {
        ASSERT_FALSE(one.done());
        EXPECT_EQ(one.input<Input>().walk, i);
        EXPECT_EQ(one.sensors().size(), i == 1 ? 1u : 0u);
        EXPECT_TRUE(one.check(Hashes{10u + unsigned(i), 20u}));
    }
    EXPECT_TRUE(one.done());
    EXPECT_FALSE(one.divergence());
    EXPECT_EQ(one.comparison().steps, 3u);
    EXPECT_EQ(one.comparison().hashes, 6u);
    EXPECT_EQ(one.comparison().equal, 3u);
    EXPECT_EQ(one.comparison().live, 2u) << "nothing is known before the first";
    EXPECT_EQ(one.comparison().changed, (Hashes{2, 0}));
    EXPECT_TRUE(one.comparison().roots);
}

TEST(Player, NamesTheFirstStepAndPartsThatDiffer) {
    Player one = player();
    EXPECT_TRUE(one.check(Hashes{10, 20}));
    EXPECT_FALSE(one.check(Hashes{11, 0xbeef}));
    EXPECT_TRUE(one.check(Hashes{12, 20})) << "equal again";
    ASSERT_TRUE(one.divergence());
    EXPECT_EQ(one.divergence()->step, 1u);
    EXPECT_EQ(one.divergence()->last, 1u);
    EXPECT_EQ(one.divergence()->parts, (std::vector<std::string>{"player"}));
    EXPECT_EQ(one.divergence()->describe().find("step 1: player: not as recorded (root "), 0u);
    EXPECT_EQ(one.comparison().equal, 1u);
}

TEST(Player, FindsEveryStretchThatDiffers) {
    Player one = player(header(), 8);
    for (unsigned i = 0; i < 8; ++i) {
        const bool wrong = i == 2 || i == 3 || i == 6;
        one.check(Hashes{10 + i, wrong ? 21u : 20u});
    }
    const auto& all = one.comparison().divergences;
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].step, 2u);
    EXPECT_EQ(all[0].last, 3u);
    EXPECT_EQ(all[1].step, 6u);
}

// A hash whose low byte is the recorded one: the root tells, and that the part changed when it should not.
TEST(Player, ATagThatIsTheSameByChanceHidesNothing) {
    Player one = player();
    EXPECT_TRUE(one.check(Hashes{10, 20}));
    EXPECT_FALSE(one.check(Hashes{11, 20 + 256}));
    EXPECT_EQ(one.divergence()->parts, (std::vector<std::string>{"player"}));

    Player at_once = player();
    EXPECT_FALSE(at_once.check(Hashes{10, 20 + 256}));
    EXPECT_TRUE(at_once.divergence()->parts.empty()) << "nothing is known before the first step";
    EXPECT_NE(at_once.divergence()->describe().find("a part whose tag is the same"), std::string::npos);
}

TEST(Player, ANewPartIsNotCompared) {
    RecordingHeader mine = header();
    mine.parts = {"torch", "door", "player"};
    mine.schemas = {3, 1, 2};
    Player one = player(mine);
    EXPECT_TRUE(one.comparison().roots) << "every recorded part is there";
    EXPECT_EQ(one.comparison().not_compared, (std::vector<std::string>{"torch: the recording has none"}));
    EXPECT_TRUE(one.check(Hashes{7, 10, 20}));
    EXPECT_TRUE(one.check(Hashes{8, 11, 20}));
    EXPECT_FALSE(one.check(Hashes{8, 12, 21}));
    EXPECT_EQ(one.divergence()->parts, (std::vector<std::string>{"player"}));
}

TEST(Player, APartOfOtherFieldsIsNotComparedTheOthersAreByTheirTags) {
    RecordingHeader mine = header();
    mine.schemas = {5, 2};
    Player one = player(mine);
    EXPECT_FALSE(one.comparison().roots);
    EXPECT_EQ(one.comparison().parts, (std::vector<std::string>{"player"}));
    EXPECT_EQ(one.comparison().not_compared, (std::vector<std::string>{"door: its fields have changed"}));
    EXPECT_TRUE(one.check(Hashes{77, 20}));
    EXPECT_FALSE(one.check(Hashes{78, 22}));
    EXPECT_EQ(one.divergence()->describe(), "step 1: player: not as recorded");
}

TEST(Player, APartThatIsGoneIsNamed) {
    RecordingHeader mine = header();
    mine.parts = {"door"};
    mine.schemas = {1};
    Player one = player(mine);
    EXPECT_EQ(one.comparison().not_compared, (std::vector<std::string>{"player: this program has none"}));
    EXPECT_TRUE(one.check(Hashes{10}));
    EXPECT_FALSE(one.check(Hashes{10}));
}

TEST(Player, AfterASeekStatesAreComparedAsEver) {
    Player one = player(header(), 10);
    one.go_to(6);
    EXPECT_TRUE(one.check(Hashes{16, 20}));
    EXPECT_FALSE(one.check(Hashes{17, 30}));
    one.go_to(2);
    EXPECT_TRUE(one.check(Hashes{12, 20}));
    EXPECT_TRUE(one.check(Hashes{13, 20}));
    EXPECT_EQ(one.comparison().divergences.size(), 1u);
}

TEST(Player, RefusesWhatWasRecordedWithSomethingElse) {
    const auto refused = [](auto alter) {
        RecordingHeader mine = header();
        alter(mine);
        EXPECT_THROW(player(mine), InputError);
    };
    refused([](RecordingHeader& h) { h.level = "other.glb"; });
    refused([](RecordingHeader& h) { h.level_hash = 6; });
    refused([](RecordingHeader& h) { h.step_rate = 30; });
    refused([](RecordingHeader& h) { h.input_format = "test-2"; });
    refused([](RecordingHeader& h) { h.input_size = 8; });
    refused([](RecordingHeader& h) {
        h.parts = {"torch"};
        h.schemas = {1};
    });
    refused([](RecordingHeader& h) { h.sensors = {}; });

    RecordingHeader other_build = header();
    other_build.build = "elsewhere";
    other_build.seed = 1;
    EXPECT_NO_THROW(player(other_build));
}

}  // namespace
}  // namespace lanthorn::replay
