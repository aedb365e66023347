// lanthorn replay state FILE: what this build makes of a recording's inputs, for another build to compare.
#include <memory>
#include <optional>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/replay/reference.h"
#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

namespace {

struct StateOptions {
    std::string file, level, out, after;
    std::optional<std::uint64_t> step;
};

ExitCode state(const StateOptions& options) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(options.file));
    const auto level = read_level(options.file, recording->header, options.level);
    if (!options.step) {
        replay::write_recording(options.out, played_again(*level, *recording, {}));
        return ExitCode::ok;
    }
    if (*options.step >= recording->steps.size()) {
        throw InputError(options.file, "--step", "found a step behind its last, expected one that it has");
    }
    ReplayedLevel replayed(*level, options.file, recording);
    write_trace(options.out, trace_step(replayed, *options.step, options.after));
    return ExitCode::ok;
}

}  // namespace

Command add_replay_state(CLI::App& replay) {
    auto options = std::make_shared<StateOptions>();
    CLI::App* command =
        replay.add_subcommand("state", "The states that this build plays a recording's inputs to.")
            ->group("");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command->add_option("--level", options->level, "the level's file")->type_name("FILE");
    command->add_option("--step", options->step, "trace this step, into OUT.json and OUT.state");
    command->add_option("--after", options->after, "the system whose state is kept; default: the last")
        ->type_name("SYSTEM");
    command->add_option("-o,--out", options->out, "recording to write, or beginning of both names")
        ->required();
    return [options] { return state(*options); };
}

}  // namespace lanthorn::tools
