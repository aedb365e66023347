#include "tools/replay_suite/slurm_array.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <set>
#include <sstream>
#include <thread>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"

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
        folder.append("/").append(name);
        if (access(folder.c_str(), X_OK) == 0) {
            return folder;
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
    Array(const ArrayWork& work, const SlurmOptions& options, std::vector<std::string>& notes)
        : work_(work), options_(options), notes_(notes) {}

    // Whether a driver that was killed left one that still runs: it is taken over.
    bool find() {
        const ChildRun run = slurm({"squeue", "-h", "-n", work_.name, "-o", "%A"});
        job_ = run.code == 0 ? first_word(run.out) : "";
        return !job_.empty();
    }

    void submit(const std::vector<std::size_t>& missing) {
        const fs::path script = work_.folder / "slurm/task.sh";
        make_folder(work_.folder / "slurm");
        const ArrayWork::Tasks tasks = work_.plan(missing);
        std::string line = "exec";
        for (const std::string& word : tasks.command) {
            line += " " + quoted(word);
        }
        write_file(script, fmt::format("#!/bin/sh\n{} \"$SLURM_ARRAY_TASK_ID\"\n", line));
        std::vector<std::string> command = {
            "sbatch",
            "--parsable",
            "--requeue",
            "--open-mode=append",
            "--job-name=" + work_.name,
            fmt::format("--array=0-{}", tasks.count - 1),
            "--output=" + fs::absolute(work_.folder / "slurm/%A-%a.log").string()};
        command.insert(command.end(), options_.sbatch.begin(), options_.sbatch.end());
        command.push_back(fs::absolute(script));
        const ChildRun run = slurm(command);
        if (run.end != ChildRun::End::exited || run.code != 0) {
            throw InputError(fmt::format("--executor slurm: sbatch refused: {}", run.err.substr(0, 300)));
        }
        job_ = first_word(run.out);
        slices_ = tasks.count;
        answered_ = Clock::now();
    }

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
            std::istringstream log(read_if_there(work_.folder / fmt::format("slurm/{}-{}.log", job_, i)));
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

    const ArrayWork& work_;
    const SlurmOptions& options_;
    std::string job_;
    std::vector<std::string>& notes_;
    std::set<std::string> released_, lost_;
    std::size_t slices_ = 0;
    bool silent_ = false;
    Clock::time_point answered_ = Clock::now();
};

}  // namespace

std::vector<std::vector<std::size_t>> cut_slices(const std::vector<double>& work, double seconds) {
    std::vector<std::size_t> order(work.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return work[i]; });
    const double sum = std::accumulate(work.begin(), work.end(), 0.0);
    const auto count = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(sum / seconds)), 1,
                                               std::max<std::size_t>(work.size(), 1));
    std::vector<std::vector<std::size_t>> cut(count);
    std::vector<double> load(count, 0);
    for (const std::size_t i : order) {
        const auto least = static_cast<std::size_t>(std::ranges::min_element(load) - load.begin());
        cut[least].push_back(i);
        load[least] += work[i];
    }
    std::erase_if(cut, [](const auto& slice) { return slice.empty(); });
    return cut;
}

std::vector<std::string> run_array(const ArrayWork& work, const std::vector<std::size_t>& which,
                                   const SlurmOptions& options, const OnResult& on_result,
                                   const std::function<bool()>& stop) {
    std::vector<std::string> notes;
    std::vector<std::size_t> missing = which;
    const auto look = [&] {
        std::erase_if(missing, work.is_done);
        on_result(which.size() - missing.size());
    };
    Array array(work, options, notes);
    for (int turn = 0; turn < kSubmissions && !missing.empty() && !stop(); ++turn) {
        if (turn > 0) {
            notes.push_back(fmt::format("{} runs without a result were submitted again", missing.size()));
        }
        if (turn > 0 || !array.find()) {
            array.submit(missing);
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

void tell_slice_begins(std::size_t slice) {
    const char* node = std::getenv("SLURMD_NODENAME");
    std::fprintf(stderr, "slice %zu begins on %s\n", slice, node != nullptr ? node : "this machine");
}

}  // namespace lanthorn::suite
