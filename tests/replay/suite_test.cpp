// `lanthorn replay suite`, as people and continuous integration call it: on copies of a real recording,
// whole, altered, and with faults that are made on the way.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/replay/recording.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing_tools::file_bytes;
using testing_tools::Outcome;
using testing_tools::run_program;

constexpr std::size_t kSteps = 240;  // of the recordings here

// Two recordings, the beginnings of one that the project has, and where reports go.
class Suite : public testing::Test {
  protected:
    Suite() {
        fs::create_directory(recordings());
        replay::Recording recording =
            replay::read_recording(support::repository_file("tests/replay/red-wall.rec"));
        recording.annotations = {};
        recording.steps.resize(kSteps);
        replay::write_recording(file("a.rec"), recording);
        recording.steps.resize(kSteps / 2);
        replay::write_recording(file("b.rec"), recording);
    }
    std::string recordings() const { return folder.path("recordings"); }
    std::string file(const std::string& name) const { return recordings() + "/" + name; }

    Outcome suite(std::vector<std::string> options = {}) const {
        options.insert(options.begin(),
                       {"replay", "suite", recordings(), "-o", folder.path("out"), "--today", today});
        return run_program(LANTHORN_BINARY, options);
    }
    // The first run of a suite, which has no ratchet yet.
    void begin() const { ASSERT_EQ(suite({"--update-ratchet"}).code, 0); }
    json report() const { return parse_json(file_bytes(folder.path("out/suite.json")), "suite.json"); }
    json row(const std::string& id) const {
        const json all = report();
        for (const json& row : all["rows"]) {
            if (row["id"] == id) {
                return row;
            }
        }
        ADD_FAILURE() << "no row " << id;
        return {};
    }
    // Results as they lie there, without what may differ between two runs.
    std::map<std::string, json> results() const {
        std::map<std::string, json> all;
        for (const std::string& name : testing_tools::files_in(folder.path("out/results"))) {
            if (name.ends_with(".json")) {
                all[name] = parse_json(file_bytes(folder.path("out/results/" + name)), name);
                all[name].erase("times");
            }
        }
        return all;
    }

    const testing_tools::TemporaryFolder folder;
    std::string today = "2026-11-26";
};

TEST_F(Suite, IsGreenAndProvesThatItRan) {
    const Outcome first = suite();
    EXPECT_EQ(first.code, 1);  // nothing to hold it against
    EXPECT_NE(first.out.find("--update-ratchet"), std::string::npos) << first.out;
    begin();
    const Outcome again =
        suite({"--junit", folder.path("j.xml"), "--html", folder.path("p.html"), "--coverage"});
    EXPECT_EQ(again.code, 0) << again.out << again.err;
    EXPECT_NE(again.out.find("Compared 360 steps"), std::string::npos) << again.out;
    EXPECT_EQ(report()["receipt"]["replays"], 2);
    EXPECT_GT(report()["receipt"]["hashes"], 360 * 30);
    EXPECT_NE(file_bytes(folder.path("j.xml")).find("tests=\"2\" failures=\"0\""), std::string::npos);
    EXPECT_NE(file_bytes(folder.path("p.html")).find("All as expected"), std::string::npos);
}

TEST_F(Suite, AnAlteredRecordingFailsInEveryRun) {
    begin();
    replay::Recording recording = replay::read_recording(file("a.rec"));
    recording.steps[100].root ^= 1;
    replay::write_recording(file("a.rec"), recording);
    const Outcome outcome = suite();
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(row("a.rec")["verdict"], "failed");
    EXPECT_EQ(row("a.rec")["verify"]["divergences"][0]["step"], 100);
    EXPECT_NE(outcome.out.find("alone: again, the same"), std::string::npos) << outcome.out;
    EXPECT_EQ(row("b.rec")["verdict"], "ok");
}

TEST_F(Suite, AnotherLevelIsBadInputAndRed) {
    begin();
    const std::string level = report()["rows"][0]["verify"]["level"];
    write_file(file(level), file_bytes(support::repository_file("assets/levels/green-screen.glb")));
    // Of the recorded name but other contents, and nothing of those contents elsewhere.
    replay::Recording recording = replay::read_recording(file("a.rec"));
    recording.header.level_hash ^= 1;
    replay::write_recording(file("a.rec"), recording);
    EXPECT_EQ(suite().code, 1);
    EXPECT_EQ(row("a.rec")["verdict"], "bad_input");
}

TEST_F(Suite, ACrashIsCaughtWithStepAndPlace) {
    begin();
    const Outcome outcome = suite({"--plant", "a.rec=crash@77", "--html", folder.path("p.html")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(row("a.rec")["verdict"], "crashed");
    EXPECT_NE(outcome.out.find("SIGSEGV after step 77"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("alone: again, the same"), std::string::npos) << outcome.out;
    EXPECT_EQ(row("b.rec")["verdict"], "ok");
    if (fs::exists("/usr/bin/addr2line")) {
        EXPECT_NE(outcome.out.find("write_nowhere"), std::string::npos) << outcome.out;
    }
}

TEST_F(Suite, OneThatTakesNoStepIsStuck) {
    begin();
    EXPECT_EQ(suite({"--plant", "b.rec=hang@50", "--stuck", "1", "--only", "b.rec"}).code, 1);
    EXPECT_EQ(row("b.rec")["verdict"], "stuck");
}

TEST_F(Suite, AFlakeIsNotPardonedByItsSecondRun) {
    begin();
    const Outcome outcome = suite({"--plant", "a.rec=flaky:local_transform@50"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(row("a.rec")["verdict"], "flaky");
    EXPECT_NE(outcome.out.find("alone: ok"), std::string::npos) << outcome.out;
}

TEST_F(Suite, AKnownFailureIsAcceptedByNameUntilADay) {
    begin();
    const std::vector<std::string> fault = {"--plant", "a.rec=flip:local_transform@50"};
    EXPECT_EQ(suite(fault).code, 1);
    const std::string failure = row("a.rec")["failure"];
    const auto accept = [&](const std::string& name, const std::string& until) {
        return run_program(LANTHORN_BINARY, {"replay", "accept", name, "--suite", recordings(), "--reason",
                                             "Bullet 3.24", "--until", until, "--today", "2026-11-26"});
    };
    EXPECT_EQ(accept("none.rec-123456", "2026-12-31").code, 2);
    EXPECT_EQ(accept(failure, "2026-11-25").code, 2);
    EXPECT_EQ(accept(failure, "2026-11-26").code, 0);
    EXPECT_EQ(suite(fault).code, 0);
    EXPECT_EQ(row("a.rec")["state"], "accepted");
    today = "2026-11-27";
    EXPECT_EQ(suite(fault).code, 1);
    EXPECT_EQ(row("a.rec")["word"], "EXPIRED");
    EXPECT_EQ(suite().code, 1);  // it passes, and is accepted: needless
    EXPECT_EQ(row("a.rec")["word"], "NEEDLESS");
}

TEST_F(Suite, FewerThanLastTimeNeedAReason) {
    begin();
    fs::remove(file("b.rec"));
    EXPECT_EQ(suite().code, 1);
    EXPECT_EQ(suite({"--update-ratchet"}).code, 2);
    EXPECT_EQ(suite({"--update-ratchet", "--reason", "b was a copy of a"}).code, 0);
    EXPECT_EQ(suite().code, 0);
}

TEST_F(Suite, ResultsDoNotDependOnHowManyRunAtATime) {
    EXPECT_EQ(suite({"--jobs", "1", "--update-ratchet", "--shuffle", "2"}).code, 0);
    const auto one = results();
    EXPECT_EQ(one.size(), 6u);
    EXPECT_EQ(suite({"--jobs", "2", "--shuffle", "2"}).code, 0);
    EXPECT_EQ(results(), one);
}

TEST_F(Suite, GoesOnAfterItsDriverIsKilled) {
    begin();
    const auto whole = results();
    fs::remove_all(folder.path("out/results"));
    const pid_t driver = fork();
    if (driver == 0) {
        freopen("/dev/null", "w", stdout);
        freopen("/dev/null", "w", stderr);
        // The first recording never ends, so that the driver is killed in the middle for certain.
        execl(LANTHORN_BINARY, LANTHORN_BINARY, "replay", "suite", recordings().c_str(), "-o",
              folder.path("out").c_str(), "--jobs", "2", "--plant", "a.rec=hang@5", nullptr);
        _exit(127);
    }
    // Until the other has its result; a file is there whole or not at all.
    const auto done = [&] { return fs::exists(folder.path("out/results")) && results().size() == 1; };
    while (!done() && waitpid(driver, nullptr, WNOHANG) == 0) {
        usleep(2000);
    }
    kill(driver, SIGKILL);
    waitpid(driver, nullptr, 0);
    EXPECT_EQ(suite({"--resume"}).code, 0);
    EXPECT_EQ(results(), whole);
}

TEST_F(Suite, MutantsAreCaughtByName) {
    const Outcome outcome = suite({"--mutate", "16", "--update-ratchet"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_GT(report()["receipt"]["mutants"], 8);
    EXPECT_EQ(report()["receipt"]["mutants"], report()["mutants"].size());
}

TEST_F(Suite, WithoutSlurmSaysWhatIsMissing) {
    const Outcome outcome = run_program(
        LANTHORN_BINARY, {"replay", "suite", recordings(), "-o", folder.path("out"), "--executor", "slurm"},
        {"PATH=/nowhere"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("slurm-wlm"), std::string::npos) << outcome.err;
}

TEST_F(Suite, BadUsageIsRefusedInALine) {
    for (const std::vector<std::string>& options :
         std::vector<std::vector<std::string>>{{"--executor", "cloud"},
                                               {"--jobs", "0"},
                                               {"--only", "c.rec"},
                                               {"--plant", "c.rec=crash@1"},
                                               {"--plant", "x"},
                                               {"--junit", folder.path("absent/j.xml")}}) {
        const Outcome outcome = suite(options);
        EXPECT_EQ(outcome.code, 2) << options[0] << options[1];
        EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    }
    EXPECT_EQ(run_program(LANTHORN_BINARY, {"replay", "suite", folder.path("absent")}).code, 2);
}

}  // namespace
}  // namespace lanthorn
