// lanthorn replay solve FILE: whether a changed level is still solved.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/replay/progress_file.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/lanthorn/replay/solving.h"

namespace lanthorn::tools {

namespace {

struct SolveOptions {
    std::string file, level, result, progress;
    bool json = false;
};

ExitCode solve(const SolveOptions& options) {
    const StopSignal stop;
    ProgressFile watched(options.progress);
    const Solving solving = solve_again(options.file, options.level, [&](std::uint64_t step, std::uint64_t) {
        watched.update(step);
        return !StopSignal::asked();
    });
    if (StopSignal::asked()) {
        throw Error(ExitCode::not_judged,
                    fmt::format("{}: stopped after {} steps", StopSignal::name(), solving.steps));
    }
    if (!options.result.empty()) {
        write_file(options.result, to_json(solving));
    }
    if (options.json) {
        fmt::print("{}", to_json(solving));
    } else {
        fmt::print("{}\n", solving.words());
        for (const Solving::Reading& read : solving.readings) {
            fmt::print("  {:<20} at most {:.3g} lx at step {}, needs {:.3g} lx\n", read.name, read.most,
                       read.most_at, read.needed);
        }
    }
    return solving.solved_at ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Command add_replay_solve(CLI::App& replay) {
    auto options = std::make_shared<SolveOptions>();
    CLI::App* command = replay.add_subcommand(
        "solve",
        "Plays a recording's inputs with light sensors that read the level as it is now, and says whether it "
        "is "
        "still solved; else what does not happen first, and how many lux are missing. Needs OpenGL.");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command
        ->add_option(
            "--level", options->level,
            "the level's file; default: of the recorded name, beside the recording or among the levels")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "print JSON");
    command->add_option("--result", options->result, "also a file for that JSON")->type_name("FILE");
    command->add_option("--progress", options->progress, "file that tells the step reached, twice a second")
        ->type_name("FILE");
    return [options] { return solve(*options); };
}

}  // namespace lanthorn::tools
