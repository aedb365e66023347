#include "tools/replay_suite/slurm_executor.h"

#include <fmt/format.h>

#include "lanthorn/core/error.h"
#include "tools/replay_suite/worker.h"

namespace lanthorn::suite {

namespace fs = std::filesystem;

std::vector<std::string> run_on_slurm(const Plan& plan, const std::vector<std::size_t>& which,
                                      const ResultFiles& files, const SlurmOptions& options,
                                      const OnResult& on_result, const std::function<bool()>& stop) {
    ArrayWork work;
    work.name = "lanthorn-" + plan.key();
    work.folder = files.folder().parent_path();
    work.is_done = [&](std::size_t i) { return files.find(plan.items[i].key).has_value(); };
    work.plan = [&](const std::vector<std::size_t>& missing) {
        Plan rest = plan;
        rest.items.clear();
        for (const std::size_t i : missing) {
            rest.items.push_back(plan.items[i]);
        }
        rest.slices = slices(rest, options.slice_seconds);
        const fs::path file = work.folder / "plan.json";
        write_plan(file, rest);
        return ArrayWork::Tasks{{plan.program, "replay", "suite-slice", fs::absolute(file).string()},
                                rest.slices.size()};
    };
    return run_array(work, which, options, on_result, stop);
}

std::size_t run_slice(const std::string& plan_file, std::size_t slice, const std::function<bool()>& stop) {
    const Plan plan = read_plan(plan_file);
    if (slice >= plan.slices.size()) {
        throw InputError(
            plan_file, "",
            fmt::format("found {} slices, expected number {} among them", plan.slices.size(), slice));
    }
    tell_slice_begins(slice);
    const ResultFiles files(fs::path(plan_file).parent_path() / "results");
    const Worker worker(plan, files.folder() / "scratch", stop);
    std::size_t missing = 0;
    for (const std::size_t i : plan.slices[slice]) {
        const Item& item = plan.items.at(i);
        if (files.find(item.key)) {
            continue;
        }
        const std::optional<Result> result = stop() ? std::nullopt : worker.judge(item);
        // What this machine could not judge another may.
        if (result && result->verdict != Verdict::not_judged) {
            files.put(*result);
        } else {
            ++missing;
        }
    }
    return missing;
}

}  // namespace lanthorn::suite
