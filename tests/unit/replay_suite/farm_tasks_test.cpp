// Work that processes of this machine do, by files; with shells that make them.
#include "tools/replay_suite/farm_tasks.h"

#include <gtest/gtest.h>

#include <fstream>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::suite {
namespace {

class FarmTasks : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    // A task that runs a shell line, in which $0 is its result.
    FarmTask task(const std::string& name, const std::string& line) const {
        return {{"-c", line, path(name)}, path(name), 1};
    }
    FarmReport run(const std::vector<FarmTask>& tasks, int jobs = 2, bool stop = false) {
        return run_tasks(
            tasks, {"local", jobs, {}}, path("farm"), "/bin/sh", [&](std::size_t done) { done_ = done; },
            [stop] { return stop; });
    }
    std::string text(const std::string& name) const { return testing_tools::file_bytes(path(name)); }

    testing_tools::TemporaryFolder folder_;
    std::size_t done_ = 0;
};

TEST_F(FarmTasks, MakeWhatIsNotThere) {
    write_file(path("b"), "old\n");
    const FarmReport report =
        run({task("a", "echo new > \"$0\""), task("b", "echo new > \"$0\""), task("c", "echo new > \"$0\"")});
    EXPECT_TRUE(report.lost.empty());
    EXPECT_EQ(report.missing, 0u);
    EXPECT_EQ(done_, 3u);
    EXPECT_EQ(text("a"), "new\n");
    EXPECT_EQ(text("b"), "old\n");
}

TEST_F(FarmTasks, ThatFailAreTriedTwiceAndSayWhy) {
    const std::vector<FarmTask> tasks = {
        task("once", "echo >> \"$0.tries\"; [ $(wc -l < \"$0.tries\") -eq 2 ] && echo new > \"$0\""),
        task("never", "echo >> \"$0.tries\"; echo first >&2; echo 'lanthorn: no room' >&2; exit 3"),
        task("killed", "kill -9 $$"), task("empty", "exit 0")};
    FarmReport report = run(tasks);
    EXPECT_EQ(text("once"), "new\n");
    EXPECT_EQ(text("never.tries"), "\n\n");
    ASSERT_EQ(report.lost.size(), 3u);
    EXPECT_EQ(report.lost.at(1).why, "no room");
    EXPECT_EQ(report.lost.at(1).code, 3);
    EXPECT_EQ(report.lost.at(2).why, "SIGKILL");
    EXPECT_EQ(report.lost.at(3).why, "left no file");
    EXPECT_EQ(report.missing, 0u);
    // Another run tries again what was lost, and that alone.
    write_file(path("never"), "by hand");
    report = run(tasks);
    EXPECT_EQ(report.lost.count(1), 0u);
    EXPECT_EQ(report.lost.size(), 2u);
    EXPECT_EQ(text("once.tries"), "\n\n");
}

TEST_F(FarmTasks, ThatAreStoppedAreMissing) {
    const FarmReport report = run({task("a", "echo new > \"$0\"")}, 1, true);
    EXPECT_EQ(report.missing, 1u);
    EXPECT_TRUE(report.lost.empty());
}

TEST_F(FarmTasks, OfASliceAreDoneOneAfterTheOther) {
    const std::string plan = path("plan.json");
    write_file(plan, R"({"program": "/bin/sh", "slices": [[1, 0], [2]], "tasks": [
        {"arguments": ["-c", "cat ')" +
                         path("b") + R"(' > \"$0\"; echo a >> \"$0\"", ")" + path("a") +
                         R"("], "result": ")" + path("a") + R"("},
        {"arguments": ["-c", "echo b > \"$0\"", ")" +
                         path("b") + R"("], "result": ")" + path("b") + R"("},
        {"arguments": ["-c", "exit 5", "c"], "result": ")" +
                         path("c") + R"("}]})");
    const auto never = [] { return false; };
    EXPECT_EQ(run_task_slice(plan, 0, never), 0u);
    EXPECT_EQ(text("a"), "b\na\n");
    EXPECT_EQ(run_task_slice(plan, 1, never), 0u);  // lost, which is a result
    EXPECT_NE(text("c.lost").find("\"code\": 5"), std::string::npos);
    EXPECT_THROW(run_task_slice(plan, 2, never), InputError);
    EXPECT_THROW(run_task_slice(path("none"), 0, never), InputError);
    write_file(plan, "{\"slices\": 3}");
    EXPECT_THROW(run_task_slice(plan, 0, never), InputError);
}

TEST(Slices, TakeAboutAsLong) {
    const std::vector<double> work = {1, 9, 2, 8, 3, 7, 4, 6, 5};
    const auto slices = cut_slices(work, 15);
    ASSERT_EQ(slices.size(), 3u);
    std::vector<bool> seen(work.size());
    for (const std::vector<std::size_t>& slice : slices) {
        double sum = 0;
        for (const std::size_t i : slice) {
            sum += work[i];
            EXPECT_FALSE(seen[i]);
            seen[i] = true;
        }
        EXPECT_NEAR(sum, 15, 1);
    }
    EXPECT_EQ(cut_slices(work, 1e9).size(), 1u);
    EXPECT_EQ(cut_slices(work, 1e-9).size(), work.size());
    EXPECT_TRUE(cut_slices({}, 1).empty());
}

}  // namespace
}  // namespace lanthorn::suite
