// `lanthorn replay bisect --commits`: a fault that one of sixteen commits brings is found unattended.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/replay/recording.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;
using testing_tools::run_program;

constexpr int kCommits = 16, kFault = 11;

// A repository whose program is the real one, called by a script; the script of commit kFault and later ones
// calls it with a fault in the simulation. `build` makes the script from its source.
class Commits : public testing::Test {
  protected:
    Commits() {
        std::filesystem::create_directory(repository);
        git({"init", "--quiet"});
        for (int i = 0; i <= kCommits; ++i) {
            const std::string fault = i >= kFault ? " --mutant flip:local_transform@7" : "";
            write_file(repository + "/source",
                       i == 4 ? "broken" : "exec " LANTHORN_BINARY " \"$@\"" + fault + "\n");
            write_file(repository + "/number", std::to_string(i));
            git({"add", "-A"});
            git({"-c", "user.name=t", "-c", "user.email=t@example.org", "commit", "--quiet", "-m",
                 "Commit number " + std::to_string(i)});
        }
        replay::Recording recording =
            replay::read_recording(support::repository_file("tests/replay/red-wall.rec"));
        recording.annotations = {};
        recording.steps.resize(20);
        replay::write_recording(folder.path("a.rec"), recording);
    }
    void git(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"git", "-C", repository});
        const Outcome outcome = run_program("/usr/bin/env", arguments);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    Outcome bisect(const std::string& range) const {
        return run_program(
            LANTHORN_BINARY,
            {"replay", "bisect", folder.path("a.rec"), "--commits", range, "--repository", repository,
             "--program", "built", "--build",
             "grep -q exec source && (echo '#!/bin/sh'; cat source) > built && chmod +x built"});
    }

    const testing_tools::TemporaryFolder folder;
    const std::string repository = folder.path("repository");
};

TEST_F(Commits, TheOneThatBroughtItIsFound) {
    const Outcome outcome = bisect("HEAD~16..HEAD");
    EXPECT_NE(outcome.out.find("\"Commit number 11\""), std::string::npos) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("(6 of 16 built)"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("could not be tested"), std::string::npos) << outcome.out;
    const std::string worktrees =
        run_program("/usr/bin/env", {"git", "-C", repository, "worktree", "list"}).out;
    EXPECT_EQ(std::count(worktrees.begin(), worktrees.end(), '\n'), 1) << worktrees;
    EXPECT_FALSE(std::filesystem::exists(repository + "/built"));
}

TEST_F(Commits, RangesThatTellNothingAreRefused) {
    const auto refused = [&](const std::string& range, const char* part) {
        const Outcome outcome = bisect(range);
        EXPECT_EQ(outcome.code, 2) << outcome.out;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << range << ": " << outcome.err;
    };
    refused("HEAD", "expected GOOD..BAD");
    refused("nowhere..HEAD", "git: ");
    refused("HEAD~16..HEAD~10", "does not differ, expected BAD to");
    refused("HEAD~2..HEAD", "is not as recorded, expected GOOD to be");
    refused("HEAD..HEAD~3", "found no commits");
}

}  // namespace
}  // namespace lanthorn
