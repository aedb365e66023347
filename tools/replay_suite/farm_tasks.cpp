#include "tools/replay_suite/farm_tasks.h"

#include <fmt/format.h>

#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "tools/replay_suite/crash_text.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kTries = 2;
// A piece of work has no steps to watch; who cut it knows how long it takes.
constexpr Limits kLimits{24 * 3600.0, 24 * 3600.0, 0};

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error);
}

fs::path lost_file(const FarmTask& task) {
    return task.result + ".lost";
}

// Nothing where it is not lost.
std::optional<FarmReport::Loss> read_loss(const FarmTask& task) {
    const std::string text = read_if_there(lost_file(task));
    if (text.empty()) {
        return std::nullopt;
    }
    const json loss = parse_json_object(text, lost_file(task).string(), "why a task failed");
    return FarmReport::Loss{loss.value("why", ""), loss.value("code", 1)};
}

std::string last_line(std::string text) {
    text.erase(text.find_last_not_of(" \r\n") + 1);
    text = text.substr(text.find_last_of('\n') + 1);
    constexpr std::string_view kName = "lanthorn: ";
    return text.starts_with(kName) ? text.substr(kName.size()) : text;
}

// How a process ended that made no file.
FarmReport::Loss loss_of(const ChildRun& run) {
    switch (run.end) {
        case ChildRun::End::signalled:
            return {signal_words(run.signal), 1};
        case ChildRun::End::exited:
            return {run.code == 0 ? "left no file" : last_line(run.err), run.code == 0 ? 1 : run.code};
        default:
            return {"it cannot be run: " + last_line(run.err), 1};
    }
}

// False: it was stopped before it was done.
bool run_task(const FarmTask& task, const std::string& program, const std::vector<std::string>& environment,
              const std::function<bool()>& stop) {
    std::vector<std::string> command = {program};
    command.insert(command.end(), task.arguments.begin(), task.arguments.end());
    for (int left = kTries; !is_there(task.result); --left) {
        const ChildRun run = run_limited(command, environment, kLimits, {}, stop);
        if (stop()) {
            return is_there(task.result);
        }
        if (left == 1 && !is_there(task.result)) {
            const FarmReport::Loss loss = loss_of(run);
            write_file(lost_file(task), json{{"why", loss.why}, {"code", loss.code}}.dump(1) + "\n");
            return true;
        }
    }
    return true;
}

// With fewer processes than threads each gets its share of these, for the software rasteriser.
std::vector<std::string> share_of_machine(int jobs) {
    const int threads = static_cast<int>(std::thread::hardware_concurrency()) / jobs;
    return jobs == 1 ? std::vector<std::string>()
                     : std::vector<std::string>{fmt::format("LP_NUM_THREADS={}", std::max(1, threads))};
}

ArrayWork array_work(const std::vector<FarmTask>& tasks, const std::string& program, const fs::path& folder,
                     double slice_seconds) {
    std::string all = program;
    for (const FarmTask& task : tasks) {
        all += "\n" + task.result;
    }
    ArrayWork work;
    work.name = fmt::format("lanthorn-{:016x}", replay::hash_bytes(std::as_bytes(std::span(all))));
    work.folder = folder;
    work.is_done = [&tasks](std::size_t i) {
        return is_there(tasks[i].result) || is_there(lost_file(tasks[i]));
    };
    work.plan = [&tasks, program, folder, slice_seconds](const std::vector<std::size_t>& missing) {
        json items = json::array();
        std::vector<double> seconds;
        for (const std::size_t i : missing) {
            items.push_back({{"arguments", tasks[i].arguments}, {"result", tasks[i].result}});
            seconds.push_back(tasks[i].seconds);
        }
        const std::vector<std::vector<std::size_t>> slices = cut_slices(seconds, slice_seconds);
        const fs::path file = fs::absolute(folder / "plan.json");
        write_file(file, json{{"program", program}, {"tasks", items}, {"slices", slices}}.dump(1) + "\n");
        return ArrayWork::Tasks{{program, "farm-slice", file.string()}, slices.size()};
    };
    return work;
}

}  // namespace

FarmReport run_tasks(const std::vector<FarmTask>& tasks, const FarmChoice& choice, const fs::path& folder,
                     const std::string& program, const std::function<void(std::size_t)>& progressed,
                     const std::function<bool()>& stop) {
    make_folder(folder);
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        std::error_code ignored;
        fs::remove(lost_file(tasks[i]), ignored);  // of an earlier run
        if (!is_there(tasks[i].result)) {
            missing.push_back(i);
        }
    }
    const std::size_t there = tasks.size() - missing.size();
    FarmReport report;
    if (choice.executor == "slurm") {
        report.notes = run_array(
            array_work(tasks, program, folder, choice.slurm.slice_seconds), missing, choice.slurm,
            [&](std::size_t done) { progressed(there + done); }, stop);
    } else {
        std::mutex mutex;  // of `done`
        std::size_t done = there;
        work_through(missing.size(), choice.jobs, stop,
                     [&](std::size_t at, const std::function<bool()>& over) {
                         if (!run_task(tasks[missing[at]], program, share_of_machine(choice.jobs), over)) {
                             return false;
                         }
                         const std::lock_guard lock(mutex);
                         progressed(++done);
                         return true;
                     });
    }
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (is_there(tasks[i].result)) {
            continue;
        }
        if (const std::optional<FarmReport::Loss> loss = read_loss(tasks[i])) {
            report.lost[i] = *loss;
        } else {
            ++report.missing;
        }
    }
    return report;
}

std::size_t run_task_slice(const std::string& plan_file, std::size_t slice,
                           const std::function<bool()>& stop) {
    const json plan = parse_json_object(read_whole(plan_file), plan_file, "a plan of tasks");
    try {
        const auto slices = plan.at("slices").get<std::vector<std::vector<std::size_t>>>();
        if (slice >= slices.size()) {
            throw InputError(
                plan_file, "",
                fmt::format("found {} slices, expected number {} among them", slices.size(), slice));
        }
        tell_slice_begins(slice);
        std::size_t missing = 0;
        for (const std::size_t i : slices[slice]) {
            const json& from = plan.at("tasks").at(i);
            const FarmTask task{from.at("arguments").get<std::vector<std::string>>(), from.at("result"), 0};
            if (stop() || !run_task(task, plan.at("program"), {}, stop)) {
                ++missing;
            }
        }
        return missing;
    } catch (const json::exception& error) {
        throw InputError(plan_file, "", std::string("found no plan of tasks: ") + error.what());
    }
}

}  // namespace lanthorn::suite
