// An array of tasks on a Slurm cluster, whatever they do, and the watch over it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/replay_suite/local_executor.h"

namespace lanthorn::suite {

struct SlurmOptions {
    double slice_seconds = 30;        // of work a task
    std::vector<std::string> sbatch;  // further options: a partition, an account
};

// Items in slices of about `seconds` of work, none empty: positions in `work`, which has the seconds that
// each takes; the longest first, each into the slice that has least.
std::vector<std::vector<std::size_t>> cut_slices(const std::vector<double>& work, double seconds);

// What is run by an array.
struct ArrayWork {
    std::string name;              // of the array: the same for the same work, so that it is found again
    std::filesystem::path folder;  // of its script and logs; all nodes see it
    // Whether an item has its result.
    std::function<bool(std::size_t item)> is_done;
    // Cuts what is missing into slices, in a file for the tasks. A task is `command` with the number of its
    // slice behind it.
    struct Tasks {
        std::vector<std::string> command;
        std::size_t count = 0;
    };
    std::function<Tasks(const std::vector<std::size_t>& missing)> plan;
};

// Runs the items at `which`. Slurm runs a task at least once; what counts is what is done, so that a lost
// node or a controller that is started again costs time only. What Slurm gives up is submitted a second time;
// what is missing then is not done. Returns lines about what happened on the way. Throws InputError without
// sbatch or where it refuses.
std::vector<std::string> run_array(const ArrayWork& work, const std::vector<std::size_t>& which,
                                   const SlurmOptions& options, const OnResult& on_result,
                                   const std::function<bool()>& stop);

// What a task says first, in its log: run_array() counts those that began again.
void tell_slice_begins(std::size_t slice);

}  // namespace lanthorn::suite
