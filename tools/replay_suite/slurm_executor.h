// Runs a plan on the nodes of a Slurm cluster.
#pragma once

#include <string>
#include <vector>

#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/result.h"
#include "tools/replay_suite/slurm_array.h"

namespace lanthorn::suite {

// Makes the results that `files` lacks, of the items at `which`: by run_array(), each task a slice of the
// plan in one process of `replay suite-slice`. `files` must lie where all nodes see it.
std::vector<std::string> run_on_slurm(const Plan& plan, const std::vector<std::size_t>& which,
                                      const ResultFiles& files, const SlurmOptions& options,
                                      const OnResult& on_result, const std::function<bool()>& stop);

// The items of a slice of a plan file that have no result yet, one after the other: a task of an array. The
// plan file lies beside the folder `results`. Returns how many are without one now. Throws InputError for a
// plan or a slice that there is not.
std::size_t run_slice(const std::string& plan_file, std::size_t slice, const std::function<bool()>& stop);

}  // namespace lanthorn::suite
