// `lanthorn replay suite`, and `suite-slice`, which a farm's tasks run.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/farm/farm_options.h"
#include "tools/lanthorn/replay/level_file.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/slurm_executor.h"
#include "tools/replay_suite/suite_run.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

struct SuiteArguments {
    suite::SuiteOptions suite;
    std::string junit, html, reason;
    std::vector<std::string> planted;  // NAME=FAULT
    int heavy = 0;                     // every how many steps; 0: not
    int threads = 1;                   // of each simulation
    bool coverage = false, update_ratchet = false, pictures = false, light = false;
};

// Empty where the recording cannot be read or its level is not there: verify says so.
std::string level_of_recording(const std::string& file) {
    try {
        return fs::absolute(level_of(file, replay::read_recording(file).header)).string();
    } catch (const Error&) {
        return "";
    }
}

// The command as it was called, to be copied.
std::string command_line() {
    std::string text, all = suite::read_if_there("/proc/self/cmdline");
    for (std::size_t at = 0; at < all.size();) {
        const std::string word = all.c_str() + at;
        at += word.size() + 1;
        const bool plain = !word.empty() && word.find_first_of(" '\"\\$&|;<>()*?#~`") == std::string::npos;
        const std::string shown = text.empty() ? fs::path(word).filename().string() : word;
        text += (text.empty() ? "" : " ") + (plain ? shown : "'" + shown + "'");
    }
    return text;
}

ExitCode run(SuiteArguments& options) {
    suite::SuiteOptions& o = options.suite;
    o.program = program_path();
    o.build = build_words();
    o.command = command_line();
    if (o.today.empty()) {
        o.today = suite::today();
    } else if (!suite::is_day(o.today)) {
        throw InputError("--today: found '" + o.today + "', expected a day as in 2026-12-31");
    }
    if (options.heavy > 0) {
        o.verify_options.insert(o.verify_options.end(), {"--heavy", std::to_string(options.heavy)});
    }
    if (options.threads != 1) {
        o.verify_options.insert(o.verify_options.end(), {"--threads", std::to_string(options.threads)});
    }
    o.pictures = options.pictures;
    if (options.pictures) {
        o.verify_options.emplace_back("--pictures");
    }
    if (options.light) {
        o.verify_options.emplace_back("--light");
    }
    if (options.pictures || options.light) {
        const fs::path folder = fs::absolute(fs::path(o.output) / "pictures");
        o.verify_options.insert(o.verify_options.end(), {"--picture-out", folder.string()});
    }
    for (const std::string& plant : options.planted) {
        const std::size_t sign = plant.find('=');
        if (sign == std::string::npos) {
            throw InputError("--plant: found '" + plant + "', expected RECORDING=FAULT");
        }
        o.planted[plant.substr(0, sign)] = plant.substr(sign + 1);
    }
    suite::make_folder(o.output);
    for (const std::string& file : {options.junit, options.html}) {
        if (!file.empty()) {
            check_writable(file);  // before minutes of work
        }
    }
    const StopSignal stop;
    suite::Summary summary;
    {
        std::unique_ptr<Progress> progress;
        std::uint64_t total = 0;
        summary = suite::run_suite(o, level_of_recording,
                                   {[&](std::uint64_t done, std::uint64_t of) {
                                        if (!progress || of != total) {
                                            progress.reset();
                                            progress = std::make_unique<Progress>("replaying", total = of);
                                        }
                                        progress->update(done);
                                    },
                                    [] { return StopSignal::asked(); }});
    }
    if (options.update_ratchet && !stop.asked()) {
        suite::write_ratchet(o.folder, summary.receipt, summary.facts.asked, options.reason);
        summary.ratchet = suite::read_ratchet(o.folder);
        std::erase_if(summary.faults,
                      [](const std::string& fault) { return fault.starts_with("ratchet: "); });
    }
    write_file(fs::path(o.output) / "suite.json", suite::json_report(summary));
    if (!options.junit.empty()) {
        write_file(options.junit, suite::junit_report(summary));
    }
    if (!options.html.empty()) {
        write_file(options.html, suite::html_report(summary));
    }
    std::fputs(suite::text_report(summary).c_str(), stdout);
    if (options.coverage) {
        for (const std::string& line : suite::coverage_lines(summary.coverage)) {
            std::puts(line.c_str());
        }
    }
    if (!options.html.empty()) {
        fmt::print("page {}\n", options.html);
    }
    if (stop.asked()) {
        std::fprintf(stderr, "lanthorn: %s: stopped; the same with --resume goes on\n", StopSignal::name());
        return static_cast<ExitCode>(StopSignal::exit_code());
    }
    return static_cast<ExitCode>(summary.exit_code());
}

ExitCode run_task(const std::string& plan, std::size_t slice) {
    const StopSignal stop;
    const std::size_t missing = suite::run_slice(plan, slice, [] { return StopSignal::asked(); });
    return missing == 0 ? ExitCode::ok : ExitCode::not_judged;
}

}  // namespace

Command add_replay_suite(CLI::App& app) {
    auto options = std::make_shared<SuiteArguments>();
    suite::SuiteOptions& o = options->suite;
    o.farm.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    o.output = "out/replay-suite";
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    o.limits.memory_mib = 0;  // sanitizers reserve address space beyond any limit
#endif
    CLI::App* command = app.add_subcommand(
        "suite", "Verify every recording of a folder, in processes of their own, and report.");
    command->add_option("DIR", o.folder, "folder of recordings (*.rec)")->required();
    command->add_option("-o,--output", o.output, "folder for suite.json and what is finished")
        ->capture_default_str();
    command->add_option("--only", o.only, "names of recordings to take, separated by commas (default: all)")
        ->delimiter(',')
        ->allow_extra_args(false);
    add_farm_options(*command, o.farm);
    command->add_flag("--resume", o.resume,
                      "keep the results of an earlier run that still hold: goes on after a kill");
    command
        ->add_option("--heavy", options->heavy, "also save, load and go on from the state at every Nth step")
        ->check(CLI::Range(1, 1'000'000))
        ->type_name("N");
    command->add_option("--threads", options->threads, "of each simulation; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->add_flag("--pictures", options->pictures,
                      "also compare pictures at marks with their baselines: needs OpenGL");
    command->add_flag("--light", options->light,
                      "also compare the error of light there, against the path tracer");
    command
        ->add_option("--mutate", o.mutants,
                     "up to N faults, each of which must be caught by name; with --pictures as many in these")
        ->check(CLI::Range(1, 100000));
    command
        ->add_option("--shuffle", o.shuffles, "every recording also in N other legal orders of the schedule")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--coverage", options->coverage,
                      "say which parts change and systems run, and which replay adds what");
    command->add_option("--time-limit", o.limits.seconds, "of a replay, seconds")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    command
        ->add_option("--stuck", o.limits.stuck_seconds,
                     "seconds without a step, after which a replay is stuck")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    command->add_option("--memory", o.limits.memory_mib, "address space of a replay, MiB; 0: no limit")
        ->check(CLI::Range(0, 1 << 24))
        ->capture_default_str();
    command->add_option("--junit", options->junit, "JUnit XML to write");
    command->add_option("--html", options->html, "page to write, one file");
    command->add_flag("--update-ratchet", options->update_ratchet,
                      "write the counts of this run beside the recordings");
    command->add_option("--reason", options->reason, "why counts of --update-ratchet may fall");
    command->add_option("--today", o.today)->group("");
    command->add_option("--plant", options->planted)->allow_extra_args(false)->group("");
    return [options] { return run(*options); };
}

Command add_replay_suite_slice(CLI::App& app) {
    struct Task {
        std::string plan;
        std::size_t slice = 0;
    };
    auto task = std::make_shared<Task>();
    CLI::App* command =
        app.add_subcommand("suite-slice", "A slice of a suite's plan: what a farm's task runs.");
    command->group("");
    command->add_option("PLAN", task->plan)->required();
    command->add_option("SLICE", task->slice)->required();
    return [task] { return run_task(task->plan, task->slice); };
}

}  // namespace lanthorn::tools
