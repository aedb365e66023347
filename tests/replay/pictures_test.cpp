// Pictures and light at marks, as `lanthorn replay verify --pictures --light` judges them: real drawing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
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
using testing_tools::Outcome;
using testing_tools::run_program;

// The beginning of a recording with a mark, and its baseline: made once for all tests, which copy it.
class Pictures : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        made = std::make_unique<testing_tools::TemporaryFolder>();
        replay::Recording recording =
            replay::read_recording(support::repository_file("tests/replay/open-the-door.rec"));
        recording.annotations = {};
        recording.annotations.marks = {{40, "begin", "", "", ""}};
        recording.steps.resize(60);
        replay::write_recording(made->path("a.rec"), recording);
        accept(made->path(), {"--size", "96x64", "--picture-alone"});
    }
    static void TearDownTestSuite() { made.reset(); }

    static void accept(const std::string& suite, const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"replay",   "accept",  "a.rec:begin", "--suite", suite,
                                              "--reason", "first",   "--preset",    "low",     "--frames",
                                              "4",        "--today", "2026-11-26"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome accepted = run_program(LANTHORN_BINARY, arguments);
        ASSERT_EQ(accepted.code, 0) << accepted.err;
    }
    Pictures() { fs::copy(made->path(), folder.path("r"), fs::copy_options::recursive); }
    std::string recording() const { return folder.path("r/a.rec"); }
    std::string baseline(const char* ending) const { return folder.path("r/pictures/a/begin") + ending; }
    Outcome verify(std::vector<std::string> options) const {
        options.insert(options.begin(),
                       {"replay", "verify", recording(), "--picture-out", folder.path("out")});
        return run_program(LANTHORN_BINARY, options);
    }

    static std::unique_ptr<testing_tools::TemporaryFolder> made;
    const testing_tools::TemporaryFolder folder;
};
std::unique_ptr<testing_tools::TemporaryFolder> Pictures::made;

TEST_F(Pictures, RepeatBitForBit) {
    const Outcome outcome = verify({"--pictures"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("pictures     ok    1 marks, 1 equal to the bit"), std::string::npos)
        << outcome.out;
    EXPECT_FALSE(fs::exists(folder.path("out")));
}

TEST_F(Pictures, AreLookedAtByProcessesAsByOne) {
    const Outcome outcome = verify({recording(), "--pictures", "--jobs", "2"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("pictures     ok    1 marks, 1 equal to the bit"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(verify({"--pictures", "--jobs", "2", "--mark", "end"}).code, 2);
}

// Of each kind one: of light, of the picture, of numbers. The others take as long again
// (docs/replay-pictures.md).
TEST_F(Pictures, FindFaults) {
    for (const std::string fault : {"off", "half", "nan"}) {
        const Outcome outcome = verify({"--pictures", "--picture-fault", fault});
        EXPECT_EQ(outcome.code, 1) << fault << ": " << outcome.out << outcome.err;
        EXPECT_NE(outcome.out.find("pictures     FAIL"), std::string::npos) << fault << outcome.out;
        EXPECT_TRUE(fs::exists(folder.path("out/a.rec/begin-actual.png"))) << fault;
    }
    EXPECT_TRUE(fs::exists(folder.path("out/a.rec/begin-difference.png")));
}

TEST_F(Pictures, FailWithoutABaseline) {
    fs::remove_all(folder.path("r/pictures"));
    const Outcome outcome = verify({"--pictures", "--light"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("`lanthorn replay accept` makes it"), std::string::npos) << outcome.out;
    EXPECT_TRUE(fs::exists(folder.path("out/a.rec/begin-actual.png")));
}

TEST_F(Pictures, RefuseADamagedBaseline) {
    write_file(baseline(".png"), "no picture");
    const Outcome outcome = verify({"--pictures"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("begin.png"), std::string::npos) << outcome.err;
}

TEST_F(Pictures, RefuseAMarkThatIsNotThere) {
    const Outcome outcome = verify({"--pictures", "--mark", "end"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("found none called 'end'"), std::string::npos) << outcome.err;
    const Outcome accepted = run_program(
        LANTHORN_BINARY, {"replay", "accept", "a.rec:end", "--suite", folder.path("r"), "--reason", "why"});
    EXPECT_EQ(accepted.code, 2);
    EXPECT_EQ(accepted.error_lines(), 1) << accepted.err;
}

TEST_F(Pictures, AllowTheNoiseOfOtherSeeds) {
    // As another machine would draw it: with noise of its own.
    const Outcome outcome = verify({"--pictures", "--seed", "77"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_NE(outcome.out.find("1 marks, 0 equal to the bit"), std::string::npos) << outcome.out;
}

TEST_F(Pictures, LightIsTheSameAndWorseWithoutBounces) {
    accept(folder.path("r"), {"--size", "48x32"});
    const Outcome same = verify({"--light"});
    EXPECT_EQ(same.code, 0) << same.out;
    EXPECT_NE(same.out.find("light        ok    1 marks; 'begin' same: relRMSE"), std::string::npos)
        << same.out;
    const Outcome worse = verify({"--light", "--picture-fault", "indirect"});
    EXPECT_EQ(worse.code, 1) << worse.out;
    EXPECT_NE(worse.out.find("worse: relRMSE"), std::string::npos) << worse.out;
}

TEST_F(Pictures, FaultsInThemAreCountedInTheReceipt) {
    // The first four kinds: a lamp's 1 %, no mover, a lamp that is off, and no number.
    const Outcome outcome =
        run_program(LANTHORN_BINARY, {"replay", "suite", folder.path("r"), "--pictures", "--mutate", "4",
                                      "-o", folder.path("s"), "--update-ratchet", "--today", "2026-11-26"});
    EXPECT_NE(outcome.out.find(", in pictures "), std::string::npos) << outcome.out << outcome.err;
    const json report = parse_json(testing_tools::file_bytes(folder.path("s/suite.json")), "suite.json");
    EXPECT_GE(report["receipt"]["blemishes"], 3);
    const auto caught = [&](const char* id) {
        return std::ranges::any_of(report["mutants"],
                                   [&](const json& one) { return one["id"] == id && one["state"] == "ok"; });
    };
    EXPECT_TRUE(caught("a.rec:begin~lamp")) << outcome.out;
    EXPECT_TRUE(caught("a.rec:begin~off")) << outcome.out;
    EXPECT_TRUE(caught("a.rec:begin~nan")) << outcome.out;
}

TEST_F(Pictures, AreShownOnTheSuitesPage) {
    json figures = parse_json(testing_tools::file_bytes(baseline(".json")), "begin.json");
    for (json& seed : figures["seeds"]) {
        seed["light"][0] = 1000;
    }
    write_file(baseline(".json"), figures.dump());
    const Outcome outcome = run_program(
        LANTHORN_BINARY, {"replay", "suite", folder.path("r"), "--pictures", "-o", folder.path("s"), "--html",
                          folder.path("p.html"), "--update-ratchet", "--today", "2026-11-26"});
    EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
    const std::string page = testing_tools::file_bytes(folder.path("p.html"));
    EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    EXPECT_NE(page.find("lanthorn replay accept a.rec:begin"), std::string::npos);
    const json report = parse_json(testing_tools::file_bytes(folder.path("s/suite.json")), "suite.json");
    EXPECT_EQ(report["receipt"]["pictures"], 1);
}

}  // namespace
}  // namespace lanthorn
