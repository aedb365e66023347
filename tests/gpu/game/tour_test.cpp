// The tour of all levels without a display, as tools/play calls it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/level/campaign.h"
#include "game/level/level_files.h"
#include "game/presentation/album/page.h"
#include "tests/gpu/game/patience.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::file_bytes;
using testing_tools::run_program;

const std::vector<std::string> kNoDisplay = {"DISPLAY=", "WAYLAND_DISPLAY="};

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

// `levels`, red-wall among them, played in a picture of the size of a stamp by a tour that `more` chooses.
void expect_solved_and_shown(std::span<const std::string_view> levels, const std::vector<std::string>& more) {
    const testing_tools::TemporaryFolder folder;
    std::vector<std::string> arguments = {
        "--tour", "--size", "64x36", "--preset", "low", "--out", folder.path("a/tour")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const testing_tools::Outcome outcome = run_program(LAMPLIGHTER_BINARY, arguments, kNoDisplay);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::string page = file_bytes(folder.path("a/tour/index.html"));
    std::vector<std::string> expected = {"index.html", "tour.webp"};
    for (const std::string_view level : levels) {
        EXPECT_NE(page.find("<h2>" + read_level_info(level_path(level)).title + "</h2>"), std::string::npos);
        for (const char* number : {"-1.png", "-2.png", "-3.png"}) {
            expected.push_back(std::string(level) + number);
            EXPECT_EQ(count(page, "src=\"" + expected.back() + "\""), 1u) << expected.back();
        }
    }
    std::ranges::sort(expected);
    EXPECT_EQ(testing_tools::files_in(folder.path("a/tour")), expected);
    EXPECT_EQ(count(outcome.out, ": solved in "), levels.size()) << outcome.out;
    // Before, by the level's camera, and after, from where the game shows what has woken.
    EXPECT_NE(file_bytes(folder.path("a/tour/red-wall-1.png")),
              file_bytes(folder.path("a/tour/red-wall-3.png")));
    // RIFF, and a chunk for every picture that differs from the one before.
    const std::string moving = file_bytes(folder.path("a/tour/tour.webp"));
    EXPECT_EQ(moving.substr(0, 4), "RIFF");
    EXPECT_EQ(moving.substr(8, 4), "WEBP");
    EXPECT_GT(count(moving, "ANMF"), 20 * levels.size());
}

TEST(Tour, SolvesALevelAndShowsIt) {
    constexpr std::string_view kLevel = "red-wall";
    expect_solved_and_shown(std::span(&kLevel, 1), {"--level", level_path(kLevel)});
}

TEST(Tour, SolvesEveryLevelAndShowsThem) {
    expect_solved_and_shown(campaign(), {});
}

TEST(Tour, StoppedItLeavesWholePicturesAndNoPage) {
    const testing_tools::TemporaryFolder folder;
    const std::string out = folder.path("tour"), said = folder.path("said");
    const pid_t child = ::fork();
    if (child == 0) {
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
        std::signal(SIGINT, SIG_DFL);
        if (std::freopen(said.c_str(), "w", stderr) == nullptr) {
            ::_exit(127);
        }
        ::execl(LAMPLIGHTER_BINARY, LAMPLIGHTER_BINARY, "--tour", "--size", "96x54", "--preset", "low",
                "--out", out.c_str(), nullptr);
        ::_exit(127);
    }
    Patience patience;
    while (::access((out + "/red-wall-1.png").c_str(), R_OK) != 0 && patience.wait()) {
    }
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 130);
    // As many as it says, of which each is there whole: the signal may come after the next one, too.
    const std::vector<std::string> files = testing_tools::files_in(out);
    ASSERT_FALSE(files.empty());
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_EQ(files[i], "red-wall-" + std::to_string(i + 1) + ".png");
        const std::string bytes = file_bytes(out + '/' + files[i]);
        EXPECT_TRUE(bytes.size() > 8 && bytes.substr(bytes.size() - 8, 4) == "IEND") << files[i];
    }
    EXPECT_NE(file_bytes(said).find("lamplighter: SIGINT: stopped; " + std::to_string(files.size()) +
                                    " pictures in " + out + ", no page\n"),
              std::string::npos)
        << file_bytes(said);
}

TEST(Tour, ALevelThatItDoesNotSolveIsSaid) {
    // Without indirect light no light is red where it has to be.
    const testing_tools::Outcome outcome = run_program(
        LAMPLIGHTER_BINARY, {"--tour", "--headless", "--size", "32x18", "--set", "gi.technique=none",
                             "--level", support::repository_file("assets/levels/red-wall.glb")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.error_lines(), 1);
    EXPECT_NE(outcome.err.find("red-wall.glb: its tour does not solve it"), std::string::npos) << outcome.err;
}

TEST(TourPage, HoldsWordsOfAnyCharacters) {
    const std::string text =
        page({.moving = "tour.webp",
              .words = "a & b",
              .levels = {{"<Two> \"glasses\"", "Solved.", {{"two-1.png", "on the way"}}}}});
    EXPECT_NE(text.find("<h2>&lt;Two&gt; &quot;glasses&quot;</h2>"), std::string::npos);
    EXPECT_NE(text.find("alt=\"&lt;Two&gt; &quot;glasses&quot;: on the way\""), std::string::npos);
    EXPECT_NE(text.find("<p>a &amp; b</p>"), std::string::npos);
}

// A level's file may have any name, and a browser would take some of them apart.
TEST(TourPage, FilesOfAnyName) {
    const std::string text =
        page({.moving = "", .words = "", .levels = {{"x", "y", {{"50%20#a?b:c ä\"-1.png", "z"}}}}});
    EXPECT_NE(text.find("src=\"50%2520%23a%3Fb%3Ac%20%C3%A4%22-1.png\""), std::string::npos) << text;
}

}  // namespace
}  // namespace lanthorn::game
