// Arrays of tasks, by programs of Slurm's names that do what Slurm does when things go wrong.
#include "tools/replay_suite/slurm_array.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::suite {
namespace {

namespace fs = std::filesystem;

class SlurmArray : public testing::Test {
  protected:
    SlurmArray() {
        fs::create_directories(path("bin"));
        // A submission runs its tasks behind the caller's back, after `delay` seconds, each once.
        program("sbatch", R"sh(for a; do case $a in --array=0-*) last=${a#--array=0-};; esac; done
echo submitted >> "$here/log"
rm -f "$here/begun"
setsid sh -c 'touch "$3"; sleep "$0"; for i in $(seq 0 "$1"); do SLURM_ARRAY_TASK_ID=$i sh "$2"; done' \
    "$(cat "$here/delay")" "$last" "$a" "$here/begun" < /dev/null > /dev/null 2>&1 &
while [ ! -e "$here/begun" ]; do sleep 0.05; done  # out of reach of who ends what a call leaves behind
echo 7)sh");
        // Nothing is there by the name; of the job what `queue` says, once.
        program("squeue",
                R"(case "$*" in *-j*) cat "$here/queue" 2> /dev/null; rm -f "$here/queue";; esac; true)");
        program("sinfo", R"(echo 'n1|idle'; cat "$here/nodes" 2> /dev/null; true)");
        program("scontrol", R"(echo "scontrol $*" >> "$here/log")");
        write_file(path("delay"), "0");
        setenv("PATH", (path("bin") + ":" + before_).c_str(), 1);
    }
    ~SlurmArray() override { setenv("PATH", before_.c_str(), 1); }

    std::string path(const std::string& name) const { return folder_.path(name); }
    void program(const std::string& name, const std::string& lines) const {
        const std::string file = path("bin/" + name);
        write_file(file, "#!/bin/sh\nhere='" + folder_.path() + "'\n" + lines + "\n");
        fs::permissions(file, fs::perms::owner_all);
    }
    // Items whose tasks make a file each; a task that runs for the first time and is `lazy` makes none.
    ArrayWork work(const std::string& lazy = "none") const {
        ArrayWork work;
        work.name = "lanthorn-test";
        work.folder = path("farm");
        work.is_done = [this](std::size_t i) { return fs::exists(path(fmt::format("done-{}", i))); };
        work.plan = [this, lazy](const std::vector<std::size_t>& missing) {
            std::string items;
            for (const std::size_t i : missing) {
                items += fmt::format(" {}", i);
            }
            const std::string line = "cd '" + folder_.path() + "'; set --" + items +
                                     "; shift $0; if [ $1 = " + lazy +
                                     " ] && [ ! -e tried ]; then touch tried; else touch done-$1; fi";
            return ArrayWork::Tasks{{"/bin/sh", "-c", line}, missing.size()};
        };
        return work;
    }
    std::vector<std::string> run(const ArrayWork& work) {
        return run_array(
            work, {0, 1, 2}, {}, [&](std::size_t done) { done_ = done; }, [] { return false; });
    }
    std::string log() const { return testing_tools::file_bytes(path("log")); }

    const std::string before_ = std::getenv("PATH");
    testing_tools::TemporaryFolder folder_;
    std::size_t done_ = 0;
};

// A network's folder shows files late: the array has ended by then.
TEST_F(SlurmArray, WaitsForResultsThatAreSeenLate) {
    write_file(path("delay"), "1.5");
    EXPECT_TRUE(run(work()).empty());
    EXPECT_EQ(done_, 3u);
    EXPECT_EQ(log(), "submitted\n");
}

TEST_F(SlurmArray, SubmitsOnceMoreWhatIsGivenUp) {
    const std::vector<std::string> notes = run(work("1"));
    EXPECT_EQ(done_, 3u);
    EXPECT_EQ(log(), "submitted\nsubmitted\n");
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0], "1 runs without a result were submitted again");
}

TEST_F(SlurmArray, LetsGoWhatIsHeldAndNamesNodesThatWentDown) {
    write_file(path("delay"), "1");
    write_file(path("queue"), "7_1|PENDING|launch failed requeued held\n");
    write_file(path("nodes"), "n2|down*\n");
    const std::vector<std::string> notes = run(work());
    EXPECT_EQ(done_, 3u);
    EXPECT_EQ(log(), "submitted\nscontrol release 7_1\n");
    EXPECT_EQ(notes, (std::vector<std::string>{"task 7_1 was held back and let go", "n2 was lost"}));
}

TEST_F(SlurmArray, SaysWhatSbatchSaid) {
    program("sbatch", "echo 'invalid partition' >&2; exit 1");
    try {
        run(work());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("sbatch refused: invalid partition"), std::string::npos);
    }
}

}  // namespace
}  // namespace lanthorn::suite
