// Runs a plan on this machine.
#pragma once

#include <cstddef>
#include <functional>

#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// Told after every result: how many of the plan's items have one.
using OnResult = std::function<void(std::size_t done)>;

// item(i) for i = 0 .. count-1, `jobs` at a time, on threads of their own, until one returns false or throws,
// which comes out, or `stop` says so: that is told to `item`, too.
void work_through(std::size_t count, int jobs, const std::function<bool()>& stop,
                  const std::function<bool(std::size_t, const std::function<bool()>& stop)>& item);

// Makes the results that `files` lacks, of the items at `which` in their order, `jobs` at a time. Ends early,
// with what is done by then, once `stop` says so. Throws InputError where results cannot be written.
void run_locally(const Plan& plan, const std::vector<std::size_t>& which, const ResultFiles& files, int jobs,
                 const OnResult& on_result, const std::function<bool()>& stop);

}  // namespace lanthorn::suite
