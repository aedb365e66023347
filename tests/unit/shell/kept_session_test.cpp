// Sessions that are kept, and what becomes of those of processes that ended.
#include "lanthorn/shell/kept_session.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/kept_folder.h"

namespace lanthorn::shell {
namespace {

namespace fs = std::filesystem;

// The number of a process that has ended and been waited for.
long ended_process() {
    const pid_t child = fork();
    if (child == 0) {
        _exit(0);
    }
    waitpid(child, nullptr, 0);
    return child;
}

class KeptSessions : public support::KeptFolder {
  protected:
    // A process begins and looks after the folder.
    void look() {
        said.clear();
        const KeptSession kept(folder, [&](const std::string& line) { said.push_back(line); });
    }
};

TEST_F(KeptSessions, AreFilesOfTheirProcess) {
    KeptSession kept(folder / "sessions", {});
    const fs::path file = kept.begin();
    EXPECT_EQ(file, folder / "sessions" / ("session-" + std::to_string(getpid()) + ".rec"));
    std::ofstream(file) << "x";
    kept.drop();
    EXPECT_FALSE(fs::exists(file));
}

TEST_F(KeptSessions, WithoutAFolderAreNotKept) {
    EXPECT_TRUE(KeptSession("", {}).begin().empty());
    put("x", "file");
    EXPECT_TRUE(KeptSession(folder / "file" / "sessions", {}).begin().empty());
}

TEST_F(KeptSessions, ThatEndedAreThePreviousOne) {
    put("old", "previous.rec");
    put("new", "session-" + std::to_string(ended_process()) + ".rec");
    look();
    EXPECT_EQ(get("previous.rec"), "new");
    EXPECT_TRUE(said.empty());
}

TEST_F(KeptSessions, ThatCrashedAreToldOnceAndStay) {
    const std::string name = "session-" + std::to_string(ended_process());
    put("earlier", "crash-4.rec");
    put("crashed", name + ".rec");
    put("signal", name + ".crash");
    look();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("crash-5.rec"), std::string::npos) << said[0];
    EXPECT_EQ(get("crash-5.rec"), "crashed");
    EXPECT_EQ(get("crash-5.crash"), "signal");
    EXPECT_EQ(get("crash-4.rec"), "earlier");
    look();
    EXPECT_TRUE(said.empty());
}

TEST_F(KeptSessions, OfOthersThatPlayAreLeftAlone) {
    const std::string own = "session-" + std::to_string(getpid()) + ".rec";
    put("x", own);
    put("x", "session-1.rec");  // there is always a process 1
    put("x", "session-x.rec");
    put("x", "session-99999999999999999999.rec");
    look();
    EXPECT_TRUE(has(own));
    EXPECT_TRUE(has("session-1.rec"));
    EXPECT_TRUE(has("session-x.rec"));
    EXPECT_FALSE(has("previous.rec"));
}

TEST_F(KeptSessions, DoNotFillTheDisk) {
    for (int i = 1; i <= 11; ++i) {
        put("x", "crash-" + std::to_string(i) + ".rec");
        put("x", "crash-" + std::to_string(i) + ".crash");
    }
    look();
    EXPECT_FALSE(has("crash-3.rec"));
    EXPECT_FALSE(has("crash-3.crash"));
    EXPECT_TRUE(has("crash-4.rec"));
    EXPECT_TRUE(has("crash-11.rec"));
}

}  // namespace
}  // namespace lanthorn::shell
