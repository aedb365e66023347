// `lanthorn replay adopt`: a session that crashed becomes a test that is red, and green once the cause is
// gone.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/replay/recording.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;
using testing_tools::run_program;

class Adopt : public testing::Test {
  protected:
    Adopt() {
        replay::Recording recording =
            replay::read_recording(support::repository_file("tests/replay/red-wall.rec"));
        recording.annotations = {};
        recording.steps.resize(80);
        replay::write_recording(crashed, recording);
    }
    Outcome adopt(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"replay", "adopt", crashed, "--suite", folder.path("suite")});
        return run_program(LANTHORN_BINARY, options);
    }
    Outcome verify(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"replay", "verify", folder.path("suite/found.rec")});
        return run_program(LANTHORN_BINARY, options);
    }

    const testing_tools::TemporaryFolder folder;
    const std::string crashed = folder.path("found.rec");
};

TEST_F(Adopt, ACrashIsATestThatIsRedAndThenGreen) {
    std::filesystem::create_directory(folder.path("suite"));
    // The fault crashes in step 5, whatever the inputs: the shortest session has six steps, the last without
    // a state.
    const Outcome outcome = adopt({"--mutant", "crash:@5"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("SIGSEGV after step 5"), std::string::npos) << outcome.out;
    const replay::Recording adopted = replay::read_recording(folder.path("suite/found.rec"));
    ASSERT_EQ(adopted.steps.size(), 6u);
    EXPECT_FALSE(adopted.steps.back().is_state_known());
    EXPECT_TRUE(std::all_of(adopted.steps.begin(), adopted.steps.end() - 1,
                            [](const replay::RecordedStep& step) { return step.is_state_known(); }));
    EXPECT_EQ(verify({"--mutant", "crash:@5"}).code, -11);
    const Outcome fixed = verify();
    EXPECT_EQ(fixed.code, 0) << fixed.out << fixed.err;
    EXPECT_NE(fixed.out.find("1 steps played whose state is not known"), std::string::npos) << fixed.out;
}

TEST_F(Adopt, ASessionThatPlaysWellIsTakenAsItIs) {
    std::filesystem::create_directory(folder.path("suite"));
    const Outcome outcome = adopt({"--name", "other"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("no fault in this build"), std::string::npos) << outcome.out;
    EXPECT_EQ(replay::read_recording(folder.path("suite/other.rec")).steps,
              replay::read_recording(crashed).steps);
}

TEST_F(Adopt, RefusesWhatItCannotUse) {
    const auto refused = [&](const Outcome& outcome, const char* part) {
        EXPECT_EQ(outcome.code, 2) << outcome.out;
        EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    };
    refused(adopt(), "expected the folder of a suite's recordings");
    std::filesystem::create_directory(folder.path("suite"));
    refused(adopt({"--name", "a/b"}), "expected a name without folders");
    write_file(folder.path("suite/found.rec"), "taken");
    refused(adopt(), "is there already");
    write_file(crashed, "no recording");
    refused(adopt({"--name", "other"}), "expected it to begin with LANTHREC");
}

}  // namespace
}  // namespace lanthorn
