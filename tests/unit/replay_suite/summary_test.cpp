// What makes a suite red, and what does not.
#include "tools/replay_suite/summary.h"

#include <gtest/gtest.h>

#include "tests/unit/replay_suite/made_results.h"

namespace lanthorn::suite {
namespace {

constexpr const char* kToday = "2026-11-26";

// A ratchet that such results reach.
Ratchet reached(const std::vector<Result>& results) {
    return {receipt_of(results), "", true};
}

Summary summary_of(const std::vector<Result>& results, const std::vector<Acceptance>& accepted = {},
                   const char* day = kToday) {
    return summarise({}, results, accepted, reached(results), day, true);
}

State state_of(const Summary& summary, const std::string& id) {
    for (const Row& row : summary.rows) {
        if (row.result.id == id) {
            return row.state;
        }
    }
    ADD_FAILURE() << "no row of " << id;
    return State::ok;
}

TEST(Summary, IsGreenWhereAllPassed) {
    const Summary summary = summary_of({passed("a.rec"), passed("b.rec")});
    EXPECT_FALSE(summary.red());
    EXPECT_EQ(summary.exit_code(), 0);
    EXPECT_EQ(summary.receipt.steps, 200u);
    EXPECT_EQ(summary.receipt.hashes, 7400u);
    EXPECT_EQ(summary.receipt.parts, 1u);
    EXPECT_EQ(summary.receipt.systems, 1u);
}

TEST(Summary, PutsTheRedOnesFirst) {
    const Summary summary = summary_of({passed("a.rec"), diverged("b.rec")});
    EXPECT_EQ(summary.exit_code(), 1);
    EXPECT_EQ(summary.rows.front().result.id, "b.rec");
}

TEST(Summary, AFlakeIsAFailure) {
    Result flaky = diverged("a.rec");
    flaky.verdict = Verdict::flaky;
    EXPECT_EQ(summary_of({flaky, passed("b.rec")}).exit_code(), 1);
}

TEST(Summary, WhatCouldNotBeJudgedIsNoFailureAndNoSuccess) {
    Result lost = passed("a.rec");
    lost.verdict = Verdict::not_judged;
    EXPECT_EQ(summary_of({lost, passed("b.rec")}).exit_code(), 4);
    EXPECT_EQ(summary_of({lost, diverged("b.rec")}).exit_code(), 1);
}

TEST(Summary, AnAcceptedFailureIsListedAndNotRed) {
    const Result failure = diverged("a.rec");
    const Summary summary =
        summary_of({failure, passed("b.rec")}, {{failure.failure, "new cloth", "2026-11-26"}});
    EXPECT_EQ(summary.exit_code(), 0);
    EXPECT_EQ(state_of(summary, "a.rec"), State::accepted);
    EXPECT_NE(text_report(summary).find("new cloth"), std::string::npos);
}

TEST(Summary, AnAcceptanceThatHasExpiredIsRed) {
    const Result failure = diverged("a.rec");
    const Summary summary =
        summary_of({failure, passed("b.rec")}, {{failure.failure, "new cloth", "2026-11-26"}}, "2026-11-27");
    EXPECT_EQ(summary.exit_code(), 1);
    EXPECT_EQ(summary.rows.front().word, "EXPIRED");
}

TEST(Summary, AnAcceptanceOfWhatPassesIsRed) {
    const Summary summary = summary_of({passed("a.rec")}, {{"a.rec-123456", "was wrong once", "2026-12-31"}});
    EXPECT_EQ(summary.exit_code(), 1);
    EXPECT_EQ(summary.rows.front().word, "NEEDLESS");
}

TEST(Summary, AnAcceptanceDoesNotCoverAnotherFailureOfTheSameRecording) {
    const Summary summary =
        summary_of({diverged("a.rec", 13)}, {{diverged("a.rec", 12).failure, "new cloth", "2026-12-31"}});
    EXPECT_EQ(summary.exit_code(), 1);
    EXPECT_EQ(state_of(summary, "a.rec"), State::failed);
}

TEST(Summary, AnAcceptanceOfARecordingThatIsGoneIsRed) {
    EXPECT_EQ(summary_of({passed("a.rec")}, {{"gone.rec-123456", "why", "2026-12-31"}}).exit_code(), 1);
}

TEST(Summary, NoHashComparedIsRed) {
    Result empty = passed("a.rec");
    empty.verify["hashes_compared"] = 0u;
    EXPECT_EQ(summary_of({empty}).exit_code(), 1);
}

TEST(Summary, FewerThanLastTimeIsRed) {
    const std::vector<Result> both = {passed("a.rec"), passed("b.rec")};
    const Summary summary = summarise({}, {both[0]}, {}, reached(both), kToday, true);
    EXPECT_EQ(summary.exit_code(), 1);
    // Unless only some were asked for.
    EXPECT_EQ(summarise({}, {both[0]}, {}, reached(both), kToday, false).exit_code(), 0);
}

TEST(Summary, NoRatchetIsRed) {
    EXPECT_EQ(summarise({}, {passed("a.rec")}, {}, {}, kToday, true).exit_code(), 1);
}

TEST(Summary, ASurvivingMutantIsRed) {
    Result mutant = passed("a.rec~flip:door@3");
    mutant.kind = ItemKind::mutant;
    mutant.verify["mutant"] = {{"made", true}};
    EXPECT_EQ(summary_of({passed("a.rec"), mutant}).exit_code(), 0);
    EXPECT_EQ(summary_of({passed("a.rec"), mutant}).receipt.mutants, 1u);
    mutant.verdict = Verdict::failed;
    EXPECT_EQ(summary_of({passed("a.rec"), mutant}).exit_code(), 1);
}

TEST(Summary, OneInTwentyFaultsOfPicturesMaySurvive) {
    std::vector<Result> results = {passed("a.rec")};
    for (int i = 0; i < 20; ++i) {
        Result blemish = passed("a.rec:door~" + std::to_string(i));
        blemish.kind = ItemKind::blemish;
        blemish.verify["mutant"] = {{"made", true}};
        results.push_back(blemish);
    }
    results[1].verdict = Verdict::failed;
    const Summary one = summary_of(results);
    EXPECT_EQ(one.exit_code(), 0);
    EXPECT_EQ(one.receipt.blemishes, 19u);
    EXPECT_EQ(one.receipt.mutants, 0u);
    EXPECT_EQ(one.mutants.front().word, "SURVIVED");
    EXPECT_NE(text_report(one).find("SURVIVED"), std::string::npos);
    results[2].verdict = Verdict::failed;
    EXPECT_EQ(summary_of(results).exit_code(), 1);
}

TEST(Summary, CountsAreHeldAgainstTheRatchetWhereTheyWereAskedFor) {
    const std::vector<Result> results = {passed("a.rec")};
    Ratchet ratchet = reached(results);
    ratchet.least.pictures = 3;
    ratchet.least.blemishes = 2;
    EXPECT_EQ(summarise({}, results, {}, ratchet, kToday, true).exit_code(), 0);
    RunFacts facts;
    facts.asked = {.mutants = false, .pictures = true};
    EXPECT_EQ(summarise(facts, results, {}, ratchet, kToday, true).faults,
              std::vector<std::string>{"ratchet: 0 pictures, last time 3"});
    facts.asked.mutants = true;
    EXPECT_EQ(summarise(facts, results, {}, ratchet, kToday, true).faults.size(), 2u);
}

TEST(Reports, WriteOutWhatWouldBeMarks) {
    Result failure = diverged("a.rec");
    failure.line = "<script>alert('x')</script> & \x01";
    const Summary summary = summary_of({failure});
    for (const std::string& report : {html_report(summary), junit_report(summary)}) {
        EXPECT_EQ(report.find("<script>alert"), std::string::npos);
        EXPECT_NE(report.find("&lt;script&gt;alert"), std::string::npos);
        EXPECT_EQ(report.find('\x01'), std::string::npos);
    }
    EXPECT_EQ(html_report(summary).find("http"), std::string::npos);  // no network
}

TEST(Reports, CountWhatJUnitReads) {
    Result flaky = diverged("b.rec"), crash = diverged("c.rec");
    flaky.verdict = Verdict::flaky;
    crash.verdict = Verdict::crashed;
    crash.crash = Crash{11, 377, {"lanthorn::game::push_shutter"}};
    const std::string xml = junit_report(summary_of({passed("a.rec"), flaky, crash}));
    EXPECT_NE(xml.find("tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("push_shutter"), std::string::npos);
}

TEST(Coverage, NamesBlindSpotsAndWhatHangsOnOneReplay) {
    Result other = passed("b.rec", 50);
    other.verify["parts_changed"] = {{"door", 0}, {"cloth", 0}, {"goal", 7}};
    const Coverage coverage = coverage_of({passed("a.rec"), passed("c.rec", 400), other});
    ASSERT_EQ(coverage.parts.size(), 3u);
    EXPECT_EQ(coverage.parts[0].name, "cloth");
    EXPECT_TRUE(coverage.parts[0].replays.empty());
    EXPECT_EQ(coverage.worth[2].alone, std::vector<std::string>{"goal"});
    EXPECT_TRUE(coverage.worth[0].alone.empty());
    EXPECT_EQ(coverage.subset, (std::vector<std::string>{"b.rec", "a.rec"}));
}

}  // namespace
}  // namespace lanthorn::suite
