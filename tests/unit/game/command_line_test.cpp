// The program as people call it, without a display and without OpenGL.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::Outcome;
using testing_tools::run_program;

Outcome lamplighter(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--level", support::repository_file("assets/lantern-room.glb")});
    return run_program(LAMPLIGHTER_BINARY, arguments);
}

TEST(Lamplighter, PlaysItsTourInSilence) {
    const Outcome outcome = lamplighter({"--headless"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
}

// A level whose file has something to say of: the line names the program that speaks, and the file.
TEST(Lamplighter, WarningsNameTheGame) {
    const testing_tools::TemporaryFolder folder;
    std::string level = testing_tools::file_bytes(support::repository_file("assets/lantern-room.glb"));
    const std::string used = R"("extensionsUsed":["KHR_lights_punctual"])";
    const std::size_t at = level.find(used);
    ASSERT_NE(at, std::string::npos);
    level[at + used.size() - 3] = 'X';
    std::ofstream(folder.path("odd.glb"), std::ios::binary) << level;
    const Outcome outcome =
        run_program(LAMPLIGHTER_BINARY, {"--headless", "--level", folder.path("odd.glb")});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err,
              "lamplighter: warning: " + folder.path("odd.glb") +
                  ": /extensionsUsed: KHR_lights_punctuaX is not read; what it adds is left out\n");
}

// Nobody is there to record; tools/play says so before it installs or builds anything.
TEST(Play, RefusesWhatNeedsAWindowWithoutADisplay) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--record", "w.rec"}, {"--record=w.rec"}, {"--frames", "9"}}) {
        const Outcome outcome =
            run_program(support::repository_file("tools/play"), arguments, {"DISPLAY=", "WAYLAND_DISPLAY="});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("play: " + arguments[0].substr(0, 8))) << outcome.err;
        EXPECT_NE(outcome.err.find("there is no display"), std::string::npos) << outcome.err;
    }
}

TEST(Lamplighter, PreparesOrPlays) {
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--headless"}, {"--tour"}, {"--record", "w.rec"}, {"--replay", "w.rec"}}) {
        std::vector<std::string> arguments = other;
        arguments.emplace_back("--prepare");
        const Outcome outcome = lamplighter(arguments);
        EXPECT_EQ(outcome.code, 2) << other.front();
        EXPECT_EQ(outcome.err,
                  "lamplighter: usage: --prepare excludes --headless, --tour, --record and --replay\n");
    }
}

TEST(Lamplighter, MoreThreadsThanCoresAreNoMatter) {
    const Outcome outcome = lamplighter({"--headless", "--threads", "1000"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST(Lamplighter, RefusesAnUnknownSettingAlsoWhereNothingIsDrawn) {
    for (const std::vector<std::string>& bad :
         {std::vector<std::string>{"--set", "nope=1"}, {"--preset", "nope"}}) {
        std::vector<std::string> arguments = bad;
        arguments.emplace_back("--headless");
        const Outcome outcome = lamplighter(arguments);
        EXPECT_EQ(outcome.code, 2) << bad.back();
        EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("nope"), std::string::npos) << outcome.err;
    }
}

// Before any window: here there is no display.
TEST(Lamplighter, RefusesAnUnknownSettingAlsoBeforeTheTitle) {
    for (const std::vector<std::string>& bad :
         {std::vector<std::string>{"--set", "nope=1"}, {"--preset", "nope"}}) {
        const Outcome outcome = run_program(LAMPLIGHTER_BINARY, bad, {"DISPLAY=", "WAYLAND_DISPLAY="});
        EXPECT_EQ(outcome.code, 2) << bad.back();
        EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("nope"), std::string::npos) << outcome.err;
    }
}

TEST(Lamplighter, SaysWhatIsWrongWithASeed) {
    const Outcome outcome = lamplighter({"--headless", "--seed", "-1"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "lamplighter: --seed: found '-1', expected a whole number from 0 to 18446744073709551615\n");
}

TEST(Lamplighter, SaysThatNothingArrived) {
    for (const char* arguments : {"--print-schedule", "--help"}) {
        const Outcome outcome =
            run_program("/bin/sh", {"-c", std::string(LAMPLIGHTER_BINARY) + ' ' + arguments + " >/dev/full"});
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_EQ(outcome.err, "lamplighter: standard output: cannot be written: No space left on device\n");
    }
}

}  // namespace
}  // namespace lanthorn::game
