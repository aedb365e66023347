// The game as a person starts it: from the title by keys into a level, pause, another preset, quit, and on
// from what was kept.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "game/preferences.h"
#include "game/progress.h"
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

    void start() {
        child_ = ::fork();
        if (child_ == 0) {
            ::setenv("XDG_CONFIG_HOME", folder_.path("config").c_str(), 1);
            ::setenv("XDG_DATA_HOME", folder_.path("data").c_str(), 1);
            ::setenv("LANTHORN_ASSETS", assets_.c_str(), 1);
            if (std::freopen(folder_.path("said").c_str(), "w", stderr) == nullptr) {
                ::_exit(127);
            }
            ::execl(LAMPLIGHTER_BINARY, LAMPLIGHTER_BINARY, "--size", "160x90", "--preset", "low", nullptr);
            ::_exit(127);
        }
        keys("search --sync --onlyvisible --name lamplighter windowfocus --sync");
    }
    static void keys(const std::string& commands) {
        ASSERT_EQ(std::system((Patience::kLimit + "xdotool " + commands + " >/dev/null").c_str()), 0)
            << commands;
    }
    // Presses `key` until that comes true. False if the game ends before, or patience does.
    bool press_until(const std::string& key, const std::function<bool()>& holds) {
        for (int i = 0; ::waitpid(child_, nullptr, WNOHANG) == 0; ++i) {
            if (holds()) {
                return true;
            }
            if (!key.empty() && i % 10 == 0) {
                keys("key " + key);
            }
            if (!patience_.wait()) {
                return false;
            }
        }
        return false;
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
    keys("key Return");  // Play
    ASSERT_TRUE(press_until("Escape", [&] { return is_there(progress_file()); })) << said();
    const Progress left = progress();
    EXPECT_EQ(left.level, "red-wall");
    EXPECT_FALSE(left.state.empty());
    EXPECT_TRUE(left.solved.empty());

    // Escapes may have led back into the level; begin from a pause that is known: options are reached.
    const auto preset = [&] {
        return is_there(options_file()) ? preferences_from_json(file_bytes(options_file()), "options").preset
                                        : "";
    };
    keys("key Down Down Down Return Down Down Right");
    if (!press_until("", [&] { return preset() == "medium"; })) {
        keys("key Escape Down Down Down Return Down Down Right");
        ASSERT_TRUE(press_until("", [&] { return preset() == "medium"; })) << said();
    }
    keys("key Escape Up Return");  // Quit is the last
    EXPECT_EQ(end(), 0) << said();

    start();
    keys("key Return");  // Continue
    ::unlink(progress_file().c_str());
    ASSERT_TRUE(press_until("Escape", [&] { return is_there(progress_file()); })) << said();
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
    ASSERT_TRUE(press_until("", [&] { return refusals() == 1; })) << said();
    keys("key Return");  // Play
    ASSERT_TRUE(press_until("", [&] { return refusals() >= 2; })) << said();
    keys("key Up Return");  // Quit
    EXPECT_EQ(end(), 0) << said();
    EXPECT_EQ(refusals(), 2) << said();
}

TEST_F(AtTheScreens, ALevelWhoseFileIsGoneIsLeftAsAnyOther) {
    copy_levels();
    start();
    keys("key Return");  // Play
    ASSERT_TRUE(press_until("Escape", [&] { return is_there(progress_file()); })) << said();
    const Progress before = progress();
    std::filesystem::remove(first_level());
    ::unlink(progress_file().c_str());
    ASSERT_TRUE(press_until("Escape", [&] { return is_there(progress_file()); })) << said();
    EXPECT_EQ(progress().level_hash, before.level_hash);
    ::kill(child_, SIGTERM);
    EXPECT_EQ(end(), 128 + SIGTERM) << said();
}

}  // namespace
}  // namespace lanthorn::game
