// `lanthorn farm-slice`: what a farm's task runs.
#include <memory>
#include <string>

#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/commands.h"
#include "tools/replay_suite/farm_tasks.h"

namespace lanthorn::tools {

Command add_farm_slice(CLI::App& app) {
    struct Task {
        std::string plan;
        std::size_t slice = 0;
    };
    auto task = std::make_shared<Task>();
    CLI::App* command = app.add_subcommand("farm-slice", "A slice of a plan of tasks.");
    command->group("");
    command->add_option("PLAN", task->plan)->required();
    command->add_option("SLICE", task->slice)->required();
    return [task] {
        const StopSignal stop;
        const std::size_t missing =
            suite::run_task_slice(task->plan, task->slice, [] { return StopSignal::asked(); });
        return missing == 0 ? ExitCode::ok : ExitCode::not_judged;
    };
}

}  // namespace lanthorn::tools
