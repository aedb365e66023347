// The verdict over a suite: results, held against what is accepted and against the ratchet.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tools/replay_suite/accepted.h"
#include "tools/replay_suite/coverage.h"
#include "tools/replay_suite/receipt.h"
#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// How a result counts.
enum class State { ok, failed, crashed, flaky, accepted, not_judged };
inline constexpr std::size_t kStates = 6;
const char* state_name(State state);  // "not judged"

struct Row {
    Result result;
    State state = State::ok;
    std::string word;  // "ok", "FAIL", "EXPIRED", "NEEDLESS": what stands before it
    std::string note;  // the acceptance's reason and day; empty where there is none

    bool red() const { return state == State::failed || state == State::crashed || state == State::flaky; }
};

// Facts of a run, for people and for who wants to run it again.
struct RunFacts {
    std::string folder, build, machine, command, day;
    std::string executor;            // words: "on 2 processes of this machine"
    std::vector<std::string> notes;  // what happened on the way: a node that was lost
    double seconds = 0;              // wall clock
    Asked asked;
};

struct Summary {
    RunFacts facts;
    std::vector<Row> rows;  // replays and shuffles; red first, then by name
    // Faults that were made, of states and of pictures; survivors first. All faults of states must be caught,
    // and kCaught of those of pictures: above it survivors are listed as accepted.
    std::vector<Row> mutants;
    std::vector<std::string> faults;  // of the suite as a whole: the ratchet, acceptances of nothing
    Receipt receipt;
    Ratchet ratchet;
    Coverage coverage;
    std::array<std::size_t, kStates> counts{};  // of `rows`, by State

    std::size_t made(ItemKind kind) const;  // faults
    bool red() const;
    // 0 all as expected, 1 something is red, 4 not all could be judged and nothing is red.
    int exit_code() const;
};

inline constexpr double kCaught = 0.95;

// `whole`: all recordings of the folder were run, so that ratchet and acceptances apply to all.
Summary summarise(RunFacts facts, std::vector<Result> results, const std::vector<Acceptance>& accepted,
                  const Ratchet& ratchet, std::string_view today, bool whole);

// Reports: for a terminal, for programs, for continuous integration, and as one HTML page without network.
std::string text_report(const Summary& summary);
std::string json_report(const Summary& summary);
std::string junit_report(const Summary& summary);
std::string html_report(const Summary& summary);

// "7 597 580".
std::string with_spaces(std::uint64_t number);

}  // namespace lanthorn::suite
