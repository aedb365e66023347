// `lanthorn replay accept`: a known difference, by name, with a reason and a day.
#include <filesystem>
#include <memory>

#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/replay_suite/accepted.h"

namespace lanthorn::tools {

Command add_replay_accept(CLI::App& app) {
    struct Options {
        suite::Acceptance acceptance;
        std::string folder, today;
    };
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("accept", "Accept a failure that a suite reported, for a reason and until a day.");
    command->add_option("FAILURE", options->acceptance.failure, "as the suite names it: pool.rec-1a2b3c")
        ->required();
    command->add_option("--suite", options->folder, "folder of the recordings")->required();
    command->add_option("--reason", options->acceptance.reason, "why the difference is right for now")
        ->required();
    command->add_option("--until", options->acceptance.until, "last day on which it is accepted: 2026-12-31")
        ->required();
    command->add_option("--today", options->today)->group("");
    return [options] {
        const std::string recording = suite::recording_of(options->acceptance.failure);
        if (!std::filesystem::is_regular_file(std::filesystem::path(options->folder) / recording)) {
            throw InputError(options->folder, "",
                             "found no recording '" + recording +
                                 "', expected a failure as the suite names it: pool.rec-1a2b3c");
        }
        suite::accept(options->folder, options->acceptance,
                      options->today.empty() ? suite::today() : options->today);
        return ExitCode::ok;
    };
}

}  // namespace lanthorn::tools
