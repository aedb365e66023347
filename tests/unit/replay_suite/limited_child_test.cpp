// Real programs under limits.
#include "tools/replay_suite/limited_child.h"

#include <gtest/gtest.h>

#include <csignal>

#include "tests/unit/tools/run_program.h"

namespace lanthorn::suite {
namespace {

ChildRun shell(const std::string& script, const Limits& limits = {}, const std::string& progress = {}) {
    return run_limited({"/bin/sh", "-c", script}, {"SAID=from outside"}, limits, progress,
                       [] { return false; });
}

TEST(LimitedChild, TellsHowItEnded) {
    const ChildRun run = shell("echo out; echo \"$SAID\" >&2; exit 3");
    EXPECT_EQ(run.end, ChildRun::End::exited);
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(run.out, "out\n");
    EXPECT_EQ(run.err, "from outside\n");
}

TEST(LimitedChild, TellsTheSignalThatEndedIt) {
    const ChildRun run = shell("kill -SEGV $$");
    EXPECT_EQ(run.end, ChildRun::End::signalled);
    EXPECT_EQ(run.signal, SIGSEGV);
}

TEST(LimitedChild, OneThatNeverEndsIsEnded) {
    EXPECT_EQ(shell("while :; do :; done", {0.2, 60, 0}).end, ChildRun::End::timed_out);
}

TEST(LimitedChild, OneThatTakesNoStepIsStuck) {
    const testing_tools::TemporaryFolder folder;
    const ChildRun run =
        shell("echo 41 > " + folder.path("p") + "; while :; do :; done", {600, 0.2, 0}, folder.path("p"));
    EXPECT_EQ(run.end, ChildRun::End::stuck);
    EXPECT_EQ(run.last_step, 41u);
}

TEST(LimitedChild, WhatItLeavesRunningIsEndedToo) {
    // The loop in the background holds the outputs open; the shell itself has ended.
    const ChildRun run = shell("(while :; do :; done) & exit 0", {30, 30, 0});
    EXPECT_EQ(run.end, ChildRun::End::exited);
}

TEST(LimitedChild, MemoryIsBound) {
    const ChildRun run = shell("x=$(head -c 100000000 /dev/zero | tr '\\0' a); echo ${#x}", {60, 60, 64});
    EXPECT_NE(run.out, "100000000\n");
    EXPECT_EQ(shell("x=$(head -c 1000000 /dev/zero | tr '\\0' a); echo ${#x}", {60, 60, 64}).out,
              "1000000\n");
}

TEST(LimitedChild, OneThatIsNotThereIsNotStarted) {
    const ChildRun run = run_limited({"/no/such/program"}, {}, {}, {}, [] { return false; });
    EXPECT_EQ(run.end, ChildRun::End::not_started);
}

TEST(LimitedChild, StopsWhenAsked) {
    const ChildRun run =
        run_limited({"/bin/sh", "-c", "while :; do :; done"}, {}, {}, {}, [] { return true; });
    EXPECT_EQ(run.end, ChildRun::End::stopped);
}

}  // namespace
}  // namespace lanthorn::suite
