// Where commands have work done that can be done elsewhere: options that several have, said once.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tools/replay_suite/farm_tasks.h"

namespace lanthorn::tools {

// --executor, --jobs, --slice-seconds and --sbatch. --jobs is as `choice` has it by default.
void add_farm_options(CLI::App& command, suite::FarmChoice& choice);

// This program's own file: nodes of a farm find it by its path.
std::string program_path();

// Does tasks, tells how far it is on a line of its own under `words`, and what happened on the way on
// standard error. Throws Stopped where a signal ended it, which says that the same command goes on, and Error
// with the code of the first where tasks are lost or without a result, unless `keep_losses`.
suite::FarmReport do_tasks(const std::vector<suite::FarmTask>& tasks, const suite::FarmChoice& choice,
                           const std::string& folder, const std::string& words, bool keep_losses = false);

}  // namespace lanthorn::tools
