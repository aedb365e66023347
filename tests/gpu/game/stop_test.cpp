// The game as people run it, with and without a window, when it is asked to stop.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/replay/recording.h"
#include "tests/gpu/game/patience.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::file_bytes;

// A game that records, until it is stopped.
class Game {
  public:
    explicit Game(std::vector<std::string> arguments) {
        const std::string level = support::repository_file("assets/lantern-room.glb");
        arguments.insert(arguments.begin(), {LAMPLIGHTER_BINARY, "--level", level, "--record", recording(),
                                             "--size", "160x90", "--preset", "low"});
        std::vector<char*> argv;
        for (std::string& argument : arguments) {
            argv.push_back(argument.data());
        }
        argv.push_back(nullptr);
        child_ = ::fork();
        if (child_ == 0) {
            const int out = ::open(said().c_str(), O_CREAT | O_WRONLY, 0600);
            ::dup2(out, STDERR_FILENO);
            ::dup2(out, STDOUT_FILENO);
            ::setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);  // nobody's own keys
            ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
            for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
                std::signal(number, SIG_DFL);  // also where these tests run under nohup, or in the background
            }
            ::execv(argv[0], argv.data());
            ::_exit(127);
        }
    }
    ~Game() {
        if (child_ > 0) {
            ::kill(child_, SIGKILL);
            ::waitpid(child_, nullptr, 0);
        }
    }
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    std::string recording() const { return folder_.path("session.rec"); }
    std::string said() const { return folder_.path("said"); }

    // False if it ends before, or patience does.
    bool wait_until_recorded(std::size_t steps) {
        while (::waitpid(child_, nullptr, WNOHANG) == 0) {
            try {
                if (replay::read_recording(recording()).steps.size() >= steps) {
                    return true;
                }
            } catch (const InputError&) {
                // has not begun
            }
            if (!patience_.wait()) {
                return false;
            }
        }
        return false;
    }

    // The exit code; minus the signal where one ended it.
    int stop(int signal) {
        ::kill(child_, signal);
        int status = 0;
        ::waitpid(std::exchange(child_, 0), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

  private:
    testing_tools::TemporaryFolder folder_;
    Patience patience_;
    pid_t child_ = 0;
};

void check_whole(const Game& game, const std::string& beginning) {
    const std::string said = file_bytes(game.said());
    const replay::Recording recording = replay::read_recording(game.recording());
    EXPECT_EQ(recording.cut_off, "");
    const std::string steps = std::to_string(recording.steps.size());
    EXPECT_NE(said.find("lamplighter: " + beginning + ": stopped after " + steps + " "), std::string::npos)
        << said;
    EXPECT_NE(said.find("steps, which are in " + game.recording() + "\n"), std::string::npos) << said;
    const testing_tools::Outcome replayed = testing_tools::run_program(
        LAMPLIGHTER_BINARY, {"--headless", "--level", support::repository_file("assets/lantern-room.glb"),
                             "--replay", game.recording()});
    EXPECT_EQ(replayed.code, 0) << replayed.err;
}

TEST(StoppedInAWindow, TheRecordingIsWhole) {
    const struct {
        int number;
        const char* name;
    } kSignals[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
    for (const auto& [number, name] : kSignals) {
        Game game({});
        ASSERT_TRUE(game.wait_until_recorded(30)) << file_bytes(game.said());
        EXPECT_EQ(game.stop(number), 128 + number);
        check_whole(game, name);
        const std::string said = file_bytes(game.said());
        EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    }
}

TEST(StoppedInAWindow, WhatWasPlayedIsReplayed) {
    Game game({});
    ASSERT_TRUE(game.wait_until_recorded(30)) << file_bytes(game.said());
    // A recording does not begin again: this is said, and nothing else comes of it.
    ASSERT_EQ(std::system("xdotool key BackSpace"), 0);
    const std::string play =
        "mousemove_relative -- 120 30 key e keydown w key f click 4 mousemove_relative 40 0";
    ASSERT_EQ(std::system(("xdotool " + play).c_str()), 0);
    const std::size_t steps = replay::read_recording(game.recording()).steps.size();
    ASSERT_TRUE(game.wait_until_recorded(steps + 60));
    EXPECT_GT(replay::read_recording(game.recording()).steps.size(), steps + 59);
    EXPECT_EQ(game.stop(SIGTERM), 128 + SIGTERM);
    EXPECT_NE(file_bytes(game.said()).find("a recording cannot begin again"), std::string::npos)
        << file_bytes(game.said());
    ASSERT_EQ(std::system("xdotool keyup w"), 0);
    check_whole(game, "SIGTERM");
    std::vector<std::byte> seen(12);
    for (const replay::RecordedStep& step : replay::read_recording(game.recording()).steps) {
        for (std::size_t i = 0; i < seen.size(); ++i) {
            seen[i] |= step.input[i];
        }
    }
    for (const std::size_t part : {0, 4, 6, 8}) {  // forward, yaw, pitch, buttons
        EXPECT_NE(seen[part], std::byte{0}) << part;
    }
}

TEST(StoppedWithoutAWindow, TheRecordingIsWhole) {
    const testing_tools::TemporaryFolder out;
    Game game({"--headless", "--out", out.path(), "--frames", "840"});
    ASSERT_TRUE(game.wait_until_recorded(30)) << file_bytes(game.said());
    EXPECT_EQ(game.stop(SIGTERM), 128 + SIGTERM);
    check_whole(game, "SIGTERM");
    const std::size_t steps = replay::read_recording(game.recording()).steps.size();
    EXPECT_LT(steps, 840u);
    // A picture a step, and nothing half written.
    const std::vector<std::string> pictures = out.files();
    EXPECT_LE(pictures.size(), steps);
    EXPECT_TRUE(
        std::ranges::all_of(pictures, [](const std::string& name) { return name.ends_with(".png"); }));
}

}  // namespace
}  // namespace lanthorn::game
