// What is heard of the game, with its window, from beginning to end.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/repository.h"
#include "tests/support/wave_file.h"

namespace lanthorn::game {
namespace {

// She stands, walks to the lantern and carries it behind the stones, where a crystal wakes. Nothing of that
// is drawn with indirect light, which takes most of a frame: the crystal goes by what it read when this was
// recorded, and that it reads less today is said in the end.
TEST(SoundOfTheGame, ARecordedSessionIsHeard) {
    const testing_tools::TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("lamplighter"));
    std::ofstream(folder.path("lamplighter/options.json")) << R"({"version": 1, "music": 0})";
    std::ofstream(folder.path("alsoft.conf")) << support::write_to(folder.path("out.wav"));
    const testing_tools::Outcome outcome =
        testing_tools::run_program(LAMPLIGHTER_BINARY,
                                   {"--replay", support::repository_file("tests/replay/red-wall.rec"),
                                    "--level", support::repository_file("assets/levels/red-wall.glb"),
                                    "--size", "160x90", "--preset", "low", "--set", "gi.technique=none"},
                                   {"ALSOFT_DRIVERS=wave", "ALSOFT_CONF=" + folder.path("alsoft.conf"),
                                    "XDG_CONFIG_HOME=" + folder.path()});
    ASSERT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("sensor red-crystal: read"), std::string::npos) << outcome.err;
    const support::WaveFile wave(folder.path("out.wav"));
    ASSERT_GT(wave.seconds(), 14);
    // Steps, one by one: moments that are loud between such that are not.
    int loud = 0, quiet = 0;
    for (double at = 0; at < wave.seconds(); at += 0.05) {
        const double level = wave.loud(0, at, at + 0.05) + wave.loud(1, at, at + 0.05);
        loud += level > 0.02;
        quiet += level < 0.002;
    }
    EXPECT_GT(loud, 10);
    EXPECT_GT(quiet, 40);
    // The crystal hums, wakes and with it the level is solved: nothing is as loud as that.
    double loudest = 0, when = 0;
    for (double at = 0; at < wave.seconds(); at += 0.5) {
        if (wave.loud(0, at, at + 1) > loudest) {
            loudest = wave.loud(0, at, at + 1);
            when = at;
        }
    }
    EXPECT_GT(loudest, 0.05);
    EXPECT_GT(when, 5);
}

}  // namespace
}  // namespace lanthorn::game
