// A suite from its options to its verdict.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/replay_suite/farm_tasks.h"
#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/summary.h"

namespace lanthorn::suite {

struct SuiteOptions {
    std::string folder;             // of recordings
    std::string output;             // folder for results and suite.json
    FarmChoice farm;                // where
    bool resume = false;            // results that are there count
    std::vector<std::string> only;  // names of recordings; all where it is empty
    std::vector<std::string> verify_options;
    int shuffles = 0;  // other orders of the schedule, for every recording
    int mutants = 0;   // at most, all recordings together; as many again of pictures where these are compared
    bool pictures = false;  // `verify_options` ask for them
    Limits limits;
    std::string program, build;  // that has `replay verify`, absolute; words
    std::string command;         // to run this again, for people
    std::string today;           // a day
    std::map<std::string, std::string>
        planted;  // faults to make in recordings, by name: what a suite says of them
};

// What the rest is told while it goes on.
struct SuiteEvents {
    std::function<void(std::uint64_t done, std::uint64_t of)> progress;
    std::function<bool()> stop;
};

// Runs what has no result yet and judges all. Results lie in OUTPUT/results; the same with `resume` goes on
// where it was killed. Throws InputError for bad options, folders and files.
// Where `stop` ended it, what has no result is not judged.
Summary run_suite(const SuiteOptions& options, const LevelOf& level_of, const SuiteEvents& events);

}  // namespace lanthorn::suite
