#include "tools/replay_suite/suite_run.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/local_executor.h"
#include "tools/replay_suite/mutant_plan.h"
#include "tools/replay_suite/slurm_executor.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;

std::string machine_words() {
    std::string processor = "processor unknown";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) {
            processor = line.substr(line.find(':') + 2);
            break;
        }
    }
    utsname system{};
    uname(&system);
    return fmt::format("{}, {} threads, {} {}", processor, std::thread::hardware_concurrency(),
                       system.sysname, system.release);
}

// Runs what a plan lacks, by the executor that the options name.
class Runs {
  public:
    Runs(const SuiteOptions& options, const SuiteEvents& events)
        : options_(options), events_(events), files_(fs::path(options.output) / "results") {}

    std::vector<Result> run(const Plan& plan) {
        std::vector<std::size_t> missing;
        for (std::size_t i = 0; i < plan.items.size(); ++i) {
            const std::string& key = plan.items[i].key;
            const std::optional<Result> there = options_.resume ? files_.find(key) : std::nullopt;
            if (!there || there->verdict == Verdict::not_judged) {
                files_.remove(key);
                missing.push_back(i);
            }
        }
        const std::size_t there = plan.items.size() - missing.size();
        const auto told = [&](std::size_t done) { events_.progress(there + done, plan.items.size()); };
        told(0);
        if (options_.farm.executor == "slurm") {
            for (std::string& note :
                 run_on_slurm(plan, missing, files_, options_.farm.slurm, told, events_.stop)) {
                notes_.push_back(std::move(note));
            }
        } else {
            run_locally(plan, missing, files_, options_.farm.jobs, told, events_.stop);
        }
        std::vector<Result> results;
        for (const Item& item : plan.items) {
            if (std::optional<Result> result = files_.find(item.key)) {
                results.push_back(std::move(*result));
            } else {
                Result lost;
                lost.id = item.id;
                lost.key = item.key;
                lost.kind = item.kind;
                lost.line = "no result: it was not run to its end";
                results.push_back(std::move(lost));
            }
        }
        return results;
    }
    std::vector<std::string> notes() const { return notes_; }

  private:
    const SuiteOptions& options_;
    const SuiteEvents& events_;
    ResultFiles files_;
    std::vector<std::string> notes_;
};

void plant(Plan& plan, const std::map<std::string, std::string>& faults) {
    for (const auto& [name, fault] : faults) {
        const auto item = std::ranges::find(plan.items, name, &Item::id);
        if (item == plan.items.end()) {
            throw InputError("--plant: found no recording called '" + name + "'");
        }
        item->options.insert(item->options.end(), {"--mutant", fault});
        item->key = derived_key(item->key, item->options);
    }
}

}  // namespace

Summary run_suite(const SuiteOptions& options, const LevelOf& level_of, const SuiteEvents& events) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Acceptance> accepted = read_accepted(options.folder);
    const Ratchet ratchet = read_ratchet(options.folder);
    Plan plan = plan_folder(options.folder, options.program, options.build, options.verify_options,
                            options.limits, level_of, options.only);
    plant(plan, options.planted);
    const std::vector<Item> shuffled = shuffled_items(plan, options.shuffles);
    const std::vector<Item> replays = plan.items;
    plan.items.insert(plan.items.end(), shuffled.begin(), shuffled.end());
    Runs runs(options, events);
    std::vector<Result> results = runs.run(plan);
    if (options.mutants > 0 && !events.stop()) {
        const auto also = [&](std::vector<Item> items) {
            Plan more = plan;
            more.items = std::move(items);
            if (!more.items.empty()) {
                std::ranges::move(runs.run(more), std::back_inserter(results));
            }
        };
        also(watch_items(replays, results));
        also(mutant_items(replays, results, options.mutants));
        also(blemish_items(replays, results, options.pictures ? options.mutants : 0));
    }
    RunFacts facts;
    facts.folder = options.folder;
    facts.build = options.build;
    facts.machine = machine_words();
    facts.command = options.command;
    facts.day = options.today;
    facts.executor = options.farm.executor == "slurm"
                         ? "by Slurm"
                         : fmt::format("in {} processes at a time", options.farm.jobs);
    facts.notes = runs.notes();
    facts.asked = {options.mutants > 0, options.pictures};
    facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool whole = options.only.empty();
    Summary summary =
        summarise(std::move(facts), std::move(results), accepted, ratchet, options.today, whole);
    return summary;
}

}  // namespace lanthorn::suite
