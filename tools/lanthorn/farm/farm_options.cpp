#include "tools/lanthorn/farm/farm_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

void add_farm_options(CLI::App& command, suite::FarmChoice& choice) {
    command
        .add_option("--executor", choice.executor,
                    "local: processes of this machine; slurm: tasks of a cluster")
        ->check(CLI::IsMember({"local", "slurm"}));
    command
        .add_option("--jobs", choice.jobs,
                    fmt::format("processes at a time, of --executor local (default: {})",
                                choice.jobs == 1 ? "1" : "the processor's threads"))
        ->check(CLI::Range(1, 1024));
    command.add_option("--slice-seconds", choice.slurm.slice_seconds, "work of a task of --executor slurm")
        ->check(CLI::Range(0.1, 36000.0))
        ->capture_default_str();
    command
        .add_option("--sbatch", choice.slurm.sbatch,
                    "an option of sbatch, repeatable: --sbatch=--partition=night")
        ->allow_extra_args(false);
}

std::string program_path() {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? "/proc/self/exe" : path.string();
}

suite::FarmReport do_tasks(const std::vector<suite::FarmTask>& tasks, const suite::FarmChoice& choice,
                           const std::string& folder, const std::string& words, bool keep_losses) {
    suite::FarmReport report;
    {
        Progress progress(words.c_str(), tasks.size());
        report = suite::run_tasks(
            tasks, choice, folder, program_path(), [&](std::size_t done) { progress.update(done); },
            [] { return StopSignal::asked(); });
    }
    for (const std::string& note : report.notes) {
        fmt::print(stderr, "lanthorn: {}\n", note);
    }
    const std::size_t done = tasks.size() - report.missing - report.lost.size();
    if (StopSignal::asked() && report.missing > 0) {
        throw workbench::Stopped(
            words,
            fmt::format("{} of {} tasks are done and kept, the same command goes on", done, tasks.size()));
    }
    if (report.missing > 0) {
        throw Error(ExitCode::not_judged,
                    fmt::format("{}: {} of {} tasks have no result: they were not run to their ends; the "
                                "same command goes on",
                                words, report.missing, tasks.size()));
    }
    if (!report.lost.empty() && !keep_losses) {
        const suite::FarmReport::Loss& first = report.lost.begin()->second;
        throw Error(static_cast<ExitCode>(first.code),
                    fmt::format("{}: {} of {} tasks failed, the first: {}", words, report.lost.size(),
                                tasks.size(), first.why));
    }
    return report;
}

}  // namespace lanthorn::tools
