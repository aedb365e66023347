// Work of any kind for processes of this machine or of a cluster: calls of this program that make a file
// each. Truth is the files: what is there is done, whoever made it and how often.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/replay_suite/slurm_array.h"

namespace lanthorn::suite {

struct FarmTask {
    std::vector<std::string> arguments;  // of the program
    std::string result;  // absolute: the file that it makes, whole or not at all. It may be made twice
    double seconds = 0;  // an estimate, by which slices are cut
};

// Where work is done.
struct FarmChoice {
    std::string executor = "local";  // processes of this machine, or "slurm": tasks of a cluster
    int jobs = 1;                    // processes at a time, of "local"
    SlurmOptions slurm;              // of "slurm"
};

struct FarmReport {
    // Of tasks that failed, twice: why, and the program's exit code (1 where it crashed).
    struct Loss {
        std::string why;
        int code = 1;
    };
    std::map<std::size_t, Loss> lost;  // by task
    std::size_t missing = 0;           // neither done nor lost: it was stopped, or nodes were
    std::vector<std::string> notes;    // about what happened on the way
};

// Does the tasks whose results are not there. `folder`: for plan and logs of "slurm"; all nodes see it, and
// the results. A task that fails is tried a second time. `progressed`: how many are done. Throws InputError
// where the folder cannot be written, and as run_array().
FarmReport run_tasks(const std::vector<FarmTask>& tasks, const FarmChoice& choice,
                     const std::filesystem::path& folder, const std::string& program,
                     const std::function<void(std::size_t)>& progressed, const std::function<bool()>& stop);

// The tasks of a slice of a plan that run_tasks() wrote: a task of an array. Returns how many are neither
// done nor lost now. Throws InputError for a plan or a slice that there is not.
std::size_t run_task_slice(const std::string& plan_file, std::size_t slice,
                           const std::function<bool()>& stop);

}  // namespace lanthorn::suite
