// What was edited outlives the program, whatever ends it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/node_value.h"
#include "tools/editor/core/recovery_log.h"

namespace lanthorn::editor {
namespace {

namespace fs = std::filesystem;
using testing_tools::TemporaryFolder;

constexpr const char* kFolder = "LANTHORN_TEST_RECOVERY";  // to the child: where, and that it is one
constexpr int kTold = 3;                                   // a pipe's end, in the child

SessionOptions kept_in(const fs::path& folder) {
    SessionOptions options;
    options.recovery = folder / "recovery";
    return options;
}

std::string place(EditSession& session, const std::string& path) {
    return node_value(session.model(), session.registry(), session.node_at(path), "translation");
}

// Runs in a process of its own, which is killed while it waits.
TEST(RecoveryChild, EditsUntilItIsKilled) {
    const char* folder = std::getenv(kFolder);
    if (folder == nullptr) {
        GTEST_SKIP() << "runs in Recovery.SurvivesAKillInTheMiddleOfADrag";
    }
    EditSession session(kept_in(folder));
    session.open(fs::path(folder) / "scene.glb");
    session.run("move /lamp 1 2 0.5");
    session.run("set /lamp light.intensity 77");
    session.run("delete /lamp");
    session.undo();
    session.begin("drag");
    const std::string line = "move /lamp 9 9 9";
    session.preview(std::span(&line, 1));
    [[maybe_unused]] const ssize_t told = ::write(kTold, "x", 1);
    while (true) {
        ::pause();
    }
}

TEST(Recovery, SurvivesAKillInTheMiddleOfADrag) {
    const TemporaryFolder folder;
    EditSession maker;
    maker.new_room();
    maker.run("reparent /room/lamp /");
    maker.save(folder.path("scene.glb"));
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv(kFolder, folder.path().c_str(), 1);
        ::dup2(ends[1], kTold);
        ::execl("/proc/self/exe", "child", "--gtest_filter=RecoveryChild.*", static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(ends[1]);
    char told = 0;
    ASSERT_EQ(::read(ends[0], &told, 1), 1) << "the child ended before it had edited";
    ::close(ends[0]);
    // It lives, and nobody else may take its log.
    EXPECT_TRUE(left_logs(folder.path("recovery")).empty());
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));

    const std::vector<LeftLog> logs = left_logs(folder.path("recovery"));
    ASSERT_EQ(logs.size(), 1u);
    EXPECT_EQ(logs[0].edited, folder.path("scene.glb"));
    EXPECT_EQ(logs[0].steps, 3u);
    EditSession session(kept_in(folder.path()));
    const Rebased result = session.recover(logs[0].log);
    EXPECT_EQ(result.kept, 2u);
    EXPECT_TRUE(result.left.empty());
    EXPECT_EQ(place(session, "/lamp"), "[1,2,0.5]");
    EXPECT_TRUE(session.is_dirty());
    EXPECT_EQ(session.undo()->text, "set lamp light.intensity");
    session.redo();
    // It is kept again by the session that has it now, until that saves.
    EXPECT_TRUE(left_logs(folder.path("recovery")).empty());
    EXPECT_EQ(testing_tools::files_in(folder.path("recovery")).size(), 1u);
    session.save();
    EXPECT_TRUE(testing_tools::files_in(folder.path("recovery")).empty());
}

TEST(Recovery, AStepThatWasCutOffIsLeftOut) {
    const TemporaryFolder folder;
    fs::path log;
    {
        EditSession session(kept_in(folder.path()));
        session.new_room();
        session.run("move /room/lamp 1 2 0");
        const std::vector<std::string> two{"move /room/lamp 2 2 0", "set /room/lamp light.intensity 9"};
        session.run("two at once", two);
    }
    ASSERT_EQ(left_logs(folder.path("recovery")).size(), 1u);
    log = left_logs(folder.path("recovery"))[0].log;
    const std::string whole = testing_tools::file_bytes(log.string());
    const std::size_t second = whole.find("begin \"two at once\"");
    ASSERT_NE(second, std::string::npos);
    for (std::size_t size = second; size < whole.size(); size += 5) {
        std::ofstream(log, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
        ASSERT_EQ(read_log(log).steps, 1u) << "cut after " << size << " of " << whole.size();
    }
    std::ofstream(log, std::ios::binary | std::ios::trunc) << whole.substr(0, whole.size() - 1);
    EditSession session(kept_in(folder.path()));
    session.recover(log);
    EXPECT_EQ(place(session, "/room/lamp"), "[1,2,0]");
    EXPECT_THROW(read_log(folder.path("nothing")), InputError);
}

// Undone beyond what is on disk: the log begins with the scene as it was opened.
TEST(Recovery, OfWhatWasUndoneAfterSaving) {
    const TemporaryFolder folder;
    std::string expected;
    {
        EditSession session(kept_in(folder.path()));
        session.new_room();
        session.save(folder.path("room.glb"));
        session.open(folder.path("room.glb"));
        session.run("move /room/lamp 1 2 0");
        session.run("move /room/lamp 2 2 0");
        session.save();
        session.undo();
        session.undo();
        session.run("set /room/lamp light.intensity 5");
        expected = session.document().json_text();
    }
    const std::vector<LeftLog> logs = left_logs(folder.path("recovery"));
    ASSERT_EQ(logs.size(), 1u);
    EditSession session(kept_in(folder.path()));
    session.recover(logs[0].log);
    EXPECT_EQ(session.document().json_text(), expected);
    EXPECT_EQ(session.path(), folder.path("room.glb"));
    session.save();
    EXPECT_TRUE(testing_tools::files_in(folder.path("recovery")).empty());
}

// Names that would break a line or a comment.
TEST(Recovery, OfStrangeNames) {
    const TemporaryFolder folder;
    std::string expected;
    {
        EditSession session(kept_in(folder.path()));
        session.new_room();
        session.run(R"(rename /room/lamp "a #@ \"b\"\n#c/d ~")");
        const std::string path = session.path_of(session.steps().steps()[0].commands[0].touched[0]);
        session.run("move " + word(path) + " 0.1 2 0");
        expected = session.document().json_text();
    }
    EditSession session(kept_in(folder.path()));
    const Rebased result = session.recover(left_logs(folder.path("recovery")).at(0).log);
    EXPECT_TRUE(result.left.empty());
    EXPECT_EQ(session.document().json_text(), expected);
}

TEST(Recovery, AFolderThatCannotBeWrittenIsToldOnce) {
    const TemporaryFolder folder;
    std::ofstream(folder.path("recovery")) << "a file";
    EditSession session(kept_in(folder.path()));
    session.new_room();
    session.run("move /room/lamp 1 2 0");
    session.run("move /room/lamp 2 2 0");
    EXPECT_NE(session.recovery_problem().find("cannot be written"), std::string::npos);
    EXPECT_EQ(session.steps().position(), 2u);
}

}  // namespace
}  // namespace lanthorn::editor
