// lanthorn replay trim FILE: the beginning of a recording, or the shortest that still shows its fault.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/replay/expectations.h"
#include "tools/lanthorn/replay/minimise.h"
#include "tools/lanthorn/replay/reduce_steps.h"
#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

namespace {

struct TrimOptions {
    std::string file, out, level, against;
    std::optional<std::uint64_t> to;
    double seconds = 60;
    bool minimise = false;
    bool again = false;
};

void check_usage(const TrimOptions& options) {
    if ((options.to ? 1 : 0) + (options.minimise ? 1 : 0) + (options.again ? 1 : 0) == 0) {
        throw InputError("replay trim: found neither --to, --again nor --minimise, expected one of them");
    }
    if (options.minimise && (options.against.empty() || options.again)) {
        throw InputError(
            "replay trim --minimise: expected --against, the build that plays it right, and no --again");
    }
}

void print_minimised(const replay::Recording& before, const Minimised& after, double seconds,
                     const std::string& out) {
    fmt::print("shortest  {} steps ({:.1f} s), {} presses (of {} steps, {} presses), {} trials in {:.1f} s\n",
               after.recording.steps.size(),
               static_cast<double>(after.recording.steps.size()) / after.recording.header.step_rate,
               presses(after.recording.steps), before.steps.size(), presses(before.steps), after.trials,
               seconds);
    fmt::print("shows     step {}, {}, {}\n", after.cause.step, after.cause.system,
               after.cause.fields.empty() ? "entities" : after.cause.fields.front().name());
    fmt::print("in        {}\n", out);
}

ExitCode trim(const TrimOptions& options) {
    check_usage(options);
    replay::Recording recording = replay::read_recording(options.file);
    if (options.to) {
        if (*options.to > recording.steps.size()) {
            throw InputError(
                options.file, "--to",
                fmt::format("found {} steps, expected {} or more", recording.steps.size(), *options.to));
        }
        recording.steps.resize(*options.to);
        recording.cut_off.clear();
        const auto behind = [&](const auto& one) { return one.step > *options.to; };
        std::erase_if(recording.annotations.marks, behind);
        std::erase_if(recording.annotations.states, behind);
        std::erase_if(recording.annotations.expectations,
                      [&](const std::string& line) { return !is_told_within(line, *options.to); });
    }
    if (options.minimise) {
        const auto level = read_level(options.file, recording.header, options.level);
        const auto reference = program_reference(options.against, level->path);
        const auto start = std::chrono::steady_clock::now();
        const Minimised minimised = minimise(*level, recording, *reference, {.seconds = options.seconds});
        replay::write_recording(options.out, minimised.recording);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        print_minimised(recording, minimised, took.count(), options.out);
        return ExitCode::ok;
    }
    if (options.again) {
        const auto level = read_level(options.file, recording.header, options.level);
        recording = played_again(*level, recording, {});
    }
    replay::write_recording(options.out, recording);
    fmt::print("{}: {} steps\n", options.out, recording.steps.size());
    return ExitCode::ok;
}

}  // namespace

Command add_replay_trim(CLI::App& replay) {
    auto options = std::make_shared<TrimOptions>();
    CLI::App* command = replay.add_subcommand(
        "trim", "The beginning of a recording, or the shortest one that still shows the same fault.");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command->add_option("-o,--out", options->out, "recording to write")->required()->type_name("FILE");
    command->add_option("--to", options->to, "keep that many steps")->type_name("STEPS");
    command->add_flag("--again", options->again,
                      "play the inputs with this build and store its states: after a change that is meant");
    command->add_flag("--minimise", options->minimise,
                      "take out steps, presses and movements as long as the same field of the same system "
                      "differs in the same direction");
    command->add_option("--against", options->against, "the build that plays it right, for --minimise")
        ->type_name("PROGRAM");
    command->add_option("--seconds", options->seconds, "after which --minimise keeps what it has")
        ->check(CLI::Range(1.0, 86400.0))
        ->capture_default_str();
    command->add_option("--level", options->level, "the level's file; default: as verify finds it")
        ->type_name("FILE");
    return [options] { return trim(*options); };
}

}  // namespace lanthorn::tools
