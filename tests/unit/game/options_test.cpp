#include "game/presentation/options.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"

namespace lanthorn::game {
namespace {

Options parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "lamplighter");
    return parse_options(static_cast<int>(arguments.size()), arguments.data()).value();
}

TEST(Options, HaveUsefulDefaults) {
    const Options options = parse({});
    EXPECT_TRUE(options.level.ends_with("lantern-room.glb"));
    EXPECT_EQ(picture_size(options, false), ivec2(1280, 720));
    EXPECT_EQ(picture_size(options, true), ivec2(640, 360));
    EXPECT_FALSE(options.headless);
    EXPECT_EQ(options.seed, 1u);
}

TEST(Options, ReadsEverything) {
    const Options options = parse({"--headless",
                                   "--frames",
                                   "7",
                                   "--out",
                                   "x",
                                   "--size",
                                   "320x200",
                                   "--preset",
                                   "low",
                                   "--set",
                                   "gi.bounces=1",
                                   "--set",
                                   "gi.photons=100",
                                   "--seed",
                                   "18446744073709551615",
                                   "--threads",
                                   "2",
                                   "--record",
                                   "r",
                                   "--level",
                                   "l.glb",
                                   "--print-schedule"});
    EXPECT_TRUE(options.headless && options.print_schedule);
    EXPECT_EQ(options.frames, 7);
    EXPECT_EQ(options.out, "x");
    EXPECT_EQ(picture_size(options, true), ivec2(320, 200));
    EXPECT_EQ(options.preset, "low");
    EXPECT_EQ(options.set, (std::vector<std::string>{"gi.bounces=1", "gi.photons=100"}));
    EXPECT_EQ(options.seed, ~0ull);
    EXPECT_EQ(options.threads, 2);
    EXPECT_EQ(options.record, "r");
    EXPECT_EQ(options.level, "l.glb");
}

TEST(Options, ANamedRecordedOrReplayedLevelIsPlayedWithoutTitle) {
    EXPECT_FALSE(parse({"--preset", "low", "--size", "320x200"}).straight);
    for (const std::vector<const char*>& straight : {std::vector<const char*>{"--level", "l.glb"},
                                                     {"--record", "r"},
                                                     {"--replay", "r"},
                                                     {"--headless"}}) {
        EXPECT_TRUE(parse(straight).straight) << straight.front();
    }
}

// All levels, so that none is named.
TEST(Options, ATourIsOfTheCampaignUnlessALevelIsNamed) {
    EXPECT_FALSE(parse({"--tour", "--headless", "--out", "x"}).straight);
    EXPECT_FALSE(parse({"--tour", "--out", "x"}).straight);
    EXPECT_TRUE(parse({"--tour", "--level", "l.glb"}).straight);
}

TEST(Options, RefusesBadUsageInOneLine) {
    for (const std::vector<const char*>& bad : {std::vector<const char*>{"--size", "640"},
                                                {"--size", "640x"},
                                                {"--size", "0x5"},
                                                {"--size", "640x360x2"},
                                                {"--size", "99999x99999"},
                                                {"--nonsense"},
                                                {"stray"},
                                                {"--frames", "0", "--headless"},
                                                {"--frames", "3"},
                                                {"--out", "x"},
                                                {"--seed", "-1"},
                                                {"--seed", "a"},
                                                {"--seed", "18446744073709551616"},
                                                {"--seed", "1.5"},
                                                {"--seed", "5", "--replay", "a"},
                                                {"--frames", "3", "--headless"},
                                                {"--threads", "-1"},
                                                {"--record"},
                                                {"--tour", "--frames", "3", "--headless", "--out", "x"},
                                                {"--tour", "--record", "a"},
                                                {"--tour", "--replay", "a"},
                                                {"--record", "a", "--replay", "b"}}) {
        try {
            parse(bad);
            ADD_FAILURE() << bad.front() << " was accepted";
        } catch (const InputError& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            EXPECT_LT(std::string(e.what()).size(), 150u) << e.what();
        }
    }
}

}  // namespace
}  // namespace lanthorn::game
