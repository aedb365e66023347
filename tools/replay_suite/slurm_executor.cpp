#include "tools/replay_suite/slurm_executor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <set>
#include <sstream>
#include <thread>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"
#include "tools/replay_suite/worker.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kBetweenLooks = std::chrono::milliseconds(500);
constexpr auto kSilence = std::chrono::minutes(10);  // of the controller, until it counts as lost
constexpr int kLateLooks = 6;    // at a folder on a network, for files that are there already
constexpr int kSubmissions = 2;  // of the same item

std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (const std::string file = folder + "/" + name; access(file.c_str(), X_OK) == 0) {
            return file;
        }
    }
    throw InputError(fmt::format(
        "--executor slurm: found no program {}, expected Debian's slurm-wlm (slurm-client)", name));
}

ChildRun slurm(const std::vector<std::string>& command) {
    std::vector<std::string> arguments = command;
    arguments[0] = find_program(command[0]);
    return run_limited(arguments, {}, {60, 60, 0}, {}, [] { return false; });
}

std::string quoted(const std::string& text) {
    std::string to = "'";
    for (const char c : text) {
        to += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return to + "'";
}

std::string first_word(const std::string& text) {
    return text.substr(0, text.find_first_of(" \n;"));
}

// One submission of what is missing, and the watch over it.
class Array {
  public:
    Array(const Plan& plan, const fs::path& folder, const SlurmOptions& options,
          std::vector<std::string>& notes)
        : folder_(folder), name_("lanthorn-" + plan.key()), notes_(notes) {
        options_ = options;
    }

    // Whether a driver that was killed left one that still runs: it is taken over.
    bool find() {
        const ChildRun run = slurm({"squeue", "-h", "-n", name_, "-o", "%A"});
        job_ = run.code == 0 ? first_word(run.out) : "";
        return !job_.empty();
    }

    void submit(const Plan& missing) {
        Plan cut = missing;
        cut.slices = suite::slices(missing, options_.slice_seconds);
        const fs::path plan_file = folder_ / "plan.json", script = folder_ / "slurm/task.sh";
        make_folder(folder_ / "slurm");
        write_plan(plan_file, cut);
        write_file(script, fmt::format("#!/bin/sh\nexec {} replay suite-slice {} \"$SLURM_ARRAY_TASK_ID\"\n",
                                       quoted(missing.program), quoted(fs::absolute(plan_file))));
        std::vector<std::string> command = {"sbatch",
                                            "--parsable",
                                            "--requeue",
                                            "--open-mode=append",
                                            "--job-name=" + name_,
                                            fmt::format("--array=0-{}", cut.slices.size() - 1),
                                            "--output=" + fs::absolute(folder_ / "slurm/%A-%a.log").string()};
        command.insert(command.end(), options_.sbatch.begin(), options_.sbatch.end());
        command.push_back(fs::absolute(script));
        const ChildRun run = slurm(command);
        if (run.end != ChildRun::End::exited || run.code != 0) {
            throw InputError(fmt::format("--executor slurm: sbatch refused: {}", run.err.substr(0, 300)));
        }
        job_ = first_word(run.out);
        slices_ = cut.slices.size();
        answered_ = Clock::now();
    }
    std::size_t slices() const { return slices_; }

    // Whether tasks of it are still to run or running. Lets go what Slurm holds back.
    bool goes_on() {
        const ChildRun run = slurm({"squeue", "-h", "-r", "-j", job_, "-o", "%i|%T|%r"});
        if (run.end != ChildRun::End::exited || run.code != 0) {
            if (run.err.find("Invalid job id") != std::string::npos) {
                return false;  // forgotten: it is over
            }
            if (!silent_) {
                notes_.push_back("the controller did not answer for a while");
                silent_ = true;
            }
            return Clock::now() - answered_ < kSilence;
        }
        answered_ = Clock::now();
        std::istringstream lines(run.out);
        bool any = false;
        for (std::string line; std::getline(lines, line);) {
            any = true;
            const std::string task = line.substr(0, line.find('|'));
            const bool held = line.find("requeued_held") != std::string::npos ||
                              line.find("requeued held") != std::string::npos ||
                              line.find("JobHeld") != std::string::npos;
            if (held) {
                slurm({"scontrol", "release", task});
                if (released_.insert(task).second) {
                    notes_.push_back(fmt::format("task {} was held back and let go", task));
                }
            }
        }
        look_at_nodes();
        return any;
    }

    void cancel() const { slurm({"scancel", job_}); }

    // Slices that began more than once, by what they wrote.
    void tell_repeats() {
        std::size_t again = 0;
        for (std::size_t i = 0; i < slices_; ++i) {
            std::istringstream log(read_if_there(folder_ / fmt::format("slurm/{}-{}.log", job_, i)));
            int begins = 0;
            for (std::string line; std::getline(log, line);) {
                begins += line.find("begins on") != std::string::npos ? 1 : 0;
            }
            again += begins > 1 ? 1 : 0;
        }
        if (again > 0) {
            notes_.push_back(fmt::format("{} of {} slices ran again", again, slices_));
        }
    }

  private:
    void look_at_nodes() {
        const ChildRun run = slurm({"sinfo", "-h", "-N", "-o", "%N|%T"});
        std::istringstream lines(run.out);
        for (std::string line; std::getline(lines, line);) {
            const std::size_t bar = line.find('|');
            if (bar != std::string::npos && line.find("down", bar) != std::string::npos &&
                lost_.insert(line.substr(0, bar)).second) {
                notes_.push_back(fmt::format("{} was lost", line.substr(0, bar)));
            }
        }
    }

    fs::path folder_;
    std::string name_, job_;
    SlurmOptions options_;
    std::vector<std::string>& notes_;
    std::set<std::string> released_, lost_;
    std::size_t slices_ = 0;
    bool silent_ = false;
    Clock::time_point answered_ = Clock::now();
};

}  // namespace

std::vector<std::string> run_on_slurm(const Plan& plan, const std::vector<std::size_t>& which,
                                      const ResultFiles& files, const SlurmOptions& options,
                                      const OnResult& on_result, const std::function<bool()>& stop) {
    std::vector<std::string> notes;
    std::vector<std::size_t> missing = which;
    const auto look = [&] {
        std::erase_if(missing, [&](std::size_t i) { return files.find(plan.items[i].key).has_value(); });
        on_result(which.size() - missing.size());
    };
    Array array(plan, files.folder().parent_path(), options, notes);
    for (int turn = 0; turn < kSubmissions && !missing.empty() && !stop(); ++turn) {
        if (turn > 0) {
            notes.push_back(fmt::format("{} runs without a result were submitted again", missing.size()));
        }
        if (turn > 0 || !array.find()) {
            Plan rest = plan;
            rest.items.clear();
            for (const std::size_t i : missing) {
                rest.items.push_back(plan.items[i]);
            }
            array.submit(rest);
        } else {
            notes.push_back("a submission of an earlier run goes on");
        }
        for (int late = 0; !missing.empty() && late < kLateLooks;) {
            std::this_thread::sleep_for(kBetweenLooks);
            if (stop()) {
                array.cancel();
                return notes;
            }
            late = array.goes_on() ? 0 : late + 1;
            look();
        }
        array.tell_repeats();
    }
    return notes;
}

std::size_t run_slice(const std::string& plan_file, std::size_t slice, const std::function<bool()>& stop) {
    const Plan plan = read_plan(plan_file);
    if (slice >= plan.slices.size()) {
        throw InputError(
            plan_file, "",
            fmt::format("found {} slices, expected number {} among them", plan.slices.size(), slice));
    }
    const char* node = std::getenv("SLURMD_NODENAME");
    std::fprintf(stderr, "slice %zu begins on %s\n", slice, node != nullptr ? node : "this machine");
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
