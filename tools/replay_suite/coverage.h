// What of the simulation the replays exercise: which parts of its state change, which of its systems run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// A part or a system, and the replays that exercise it.
struct Covered {
    std::string name;
    std::vector<std::string> replays;
    std::uint64_t steps = 0;  // in which it changed or ran, all replays together
};

// What would be lost without a replay.
struct Worth {
    std::string replay;
    std::uint64_t steps = 0;
    std::vector<std::string> alone;  // parts and systems that no other exercises
};

struct Coverage {
    std::vector<Covered> parts, systems;  // all that there are; those without replays are the blind spots
    std::vector<Worth> worth;             // by replay, in the results' order
    std::vector<std::string> subset;      // few replays that exercise all that all of them do; greedy
};

Coverage coverage_of(const std::vector<Result>& results);

// How many are exercised by at least `least` replays.
std::size_t count_covered(const std::vector<Covered>& list, std::size_t least = 1);

// Lines for a terminal: blind spots, what hangs on a single replay, each replay's worth, the subset.
std::vector<std::string> coverage_lines(const Coverage& coverage);

}  // namespace lanthorn::suite
