// The game as a person starts it: from the title by keys into a level, pause, another preset, quit, and on
// from what was kept. A key is pressed once, on the screen that takes it: the game's log says which is shown.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "game/presentation/preferences.h"
#include "game/presentation/progress.h"
#include "lanthorn/core/error.h"
#include "tests/gpu/game/patience.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::file_bytes;

class AtTheScreens : public testing::Test {
  protected:
    ~AtTheScreens() override {
        if (child_ > 0) {
            ::kill(child_, SIGKILL);
            ::waitpid(child_, nullptr, 0);
        }
    }

    // Until the title is shown.
    void start() {
        ::unlink(log_file().c_str());
        child_ = ::fork();
        if (child_ == 0) {
            ::setenv("XDG_CONFIG_HOME", folder_.path("config").c_str(), 1);
            ::setenv("XDG_DATA_HOME", folder_.path("data").c_str(), 1);
            ::setenv("LANTHORN_ASSETS", assets_.c_str(), 1);
            if (std::freopen(folder_.path("said").c_str(), "w", stderr) == nullptr) {
                ::_exit(127);
            }
            ::execl(LAMPLIGHTER_BINARY, LAMPLIGHTER_BINARY, "--size", "160x90", "--preset", "low", "--log",
                    log_file().c_str(), nullptr);
            ::_exit(127);
        }
        keys("search --sync --onlyvisible --name lamplighter windowfocus --sync");
        ASSERT_TRUE(reaches("title")) << said();
    }
    static void keys(const std::string& commands) {
        ASSERT_EQ(std::system((Patience::kLimit + "xdotool " + commands + " >/dev/null").c_str()), 0)
            << commands;
    }
    // False if the game ends before that comes true, or patience does.
    bool comes(const std::function<bool()>& holds) {
        while (::waitpid(child_, nullptr, WNOHANG) == 0) {
            if (holds()) {
                return true;
            }
            if (!patience_.wait()) {
                return false;
            }
        }
        return false;
    }
    bool reaches(const std::string& screen) {
        return comes([&] { return shown("screen") == screen; });
    }
    // From the title into the level, and to its pause, which keeps what was done.
    void play_and_pause() {
        keys("key Return");
        ASSERT_TRUE(reaches("play")) << said();
        pause();
    }
    void pause() {
        keys("key Escape");
        ASSERT_TRUE(reaches("paused")) << said();
        ASSERT_TRUE(is_there(progress_file()));
    }
    // The exit code; minus the signal where one ended it, SIGKILL at the end of patience.
    int end() {
        int status = 0;
        pid_t ended = 0;
        while (ended == 0 && patience_.wait()) {
            ended = ::waitpid(child_, &status, WNOHANG);
        }
        if (ended == 0) {
            ::kill(child_, SIGKILL);
            ::waitpid(child_, &status, 0);
        }
        child_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    // The campaign where it may be changed, for a next start().
    void copy_levels() {
        namespace fs = std::filesystem;
        assets_ = folder_.path("assets");
        fs::create_directory(assets_);
        fs::copy(support::repository_file("assets/levels"), assets_ + "/levels", fs::copy_options::recursive);
    }
    std::string first_level() const { return assets_ + "/levels/red-wall.glb"; }

    std::string progress_file() const { return folder_.path("data/lamplighter/progress"); }
    std::string log_file() const { return folder_.path("log"); }
    // "screen" or "preset" of the last line of the log, which gets one every second, and where either
    // changes.
    std::string shown(const char* what) const {
        if (!is_there(log_file())) {
            return "";
        }
        std::string log = file_bytes(log_file());
        log.resize(log.rfind('\n') == std::string::npos ? 0 : log.rfind('\n'));
        if (log.empty()) {
            return "";
        }
        const std::size_t before = log.rfind('\n');
        return nlohmann::json::parse(log.substr(before == std::string::npos ? 0 : before + 1)).at(what);
    }
    std::string options_file() const { return folder_.path("config/lamplighter/options.json"); }
    bool is_there(const std::string& file) const { return ::access(file.c_str(), R_OK) == 0; }
    Progress progress() const { return progress_from_bytes(file_bytes(progress_file()), "progress"); }
    std::string said() const { return file_bytes(folder_.path("said")); }

    testing_tools::TemporaryFolder folder_;
    std::string assets_ = support::repository_file("assets");
    Patience patience_;
    pid_t child_ = 0;
};

TEST_F(AtTheScreens, AGameIsBegunPausedChangedLeftAndGoneOnWith) {
    start();
    EXPECT_FALSE(is_there(progress_file()));
    play_and_pause();
    const Progress left = progress();
    EXPECT_EQ(left.level, "red-wall");
    EXPECT_FALSE(left.state.empty());
    EXPECT_TRUE(left.solved.empty());

    keys("key Down Down Down Return");
    ASSERT_TRUE(reaches("options")) << said();
    keys("key Down Down Right");
    ASSERT_TRUE(comes([&] { return shown("preset") == "medium"; })) << said();
    EXPECT_EQ(preferences_from_json(file_bytes(options_file()), "options").preset, "medium");
    keys("key Escape");
    ASSERT_TRUE(reaches("paused")) << said();
    keys("key Up Return");  // Quit is the last
    EXPECT_EQ(end(), 0) << said();

    start();
    ::unlink(progress_file().c_str());
    play_and_pause();  // Continue
    EXPECT_EQ(progress().level, "red-wall");
    ::kill(child_, SIGTERM);
    EXPECT_EQ(end(), 128 + SIGTERM);
    EXPECT_EQ(said().find("begins anew"), std::string::npos) << said();
}

// The title comes back with Play as its first entry: the key that chose it must not choose it again.
TEST_F(AtTheScreens, ALevelThatDoesNotLoadIsTriedOnceAKey) {
    copy_levels();
    std::ofstream(first_level()) << "nonsense";
    start();
    const auto refusals = [&] {
        const std::string text = said();
        int count = 0;
        for (std::size_t at = text.find("red-wall.glb"); at != std::string::npos;
             at = text.find("red-wall.glb", at + 1)) {
            ++count;
        }
        return count;
    };
    ASSERT_EQ(refusals(), 1) << said();
    keys("key Return");  // Play
    ASSERT_TRUE(comes([&] { return refusals() >= 2; })) << said();
    ASSERT_TRUE(reaches("title")) << said();
    keys("key Up Return");  // Quit
    EXPECT_EQ(end(), 0) << said();
    EXPECT_EQ(refusals(), 2) << said();
}

TEST_F(AtTheScreens, ALevelWhoseFileIsGoneIsLeftAsAnyOther) {
    copy_levels();
    start();
    play_and_pause();
    const Progress before = progress();
    std::filesystem::remove(first_level());
    ::unlink(progress_file().c_str());
    keys("key Escape");
    ASSERT_TRUE(reaches("play")) << said();
    pause();
    EXPECT_EQ(progress().level_hash, before.level_hash);
    ::kill(child_, SIGTERM);
    EXPECT_EQ(end(), 128 + SIGTERM) << said();
}

}  // namespace
}  // namespace lanthorn::game
