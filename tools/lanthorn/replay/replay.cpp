// lanthorn replay: recorded sessions as tests (docs/replay.md).
#include <utility>
#include <vector>

#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

Command add_replay(CLI::App& app) {
    CLI::App* replay =
        app.add_subcommand("replay", "Recorded sessions of the game: as tests, and to look at.");
    replay->require_subcommand(1);
    std::vector<std::pair<CLI::App*, Command>> commands;
    for (const auto add :
         {add_replay_record, add_replay_play, add_replay_info, add_replay_verify, add_replay_bisect,
          add_replay_solve, add_replay_trim, add_replay_pack, add_replay_state, add_replay_accept,
          add_replay_adopt, add_replay_suite, add_replay_suite_slice}) {
        Command command = add(*replay);
        commands.emplace_back(replay->get_subcommands({}).back(), std::move(command));
    }
    return [commands] {
        for (const auto& [subcommand, command] : commands) {
            if (subcommand->parsed()) {
                return command();
            }
        }
        return ExitCode::bad_input;
    };
}

}  // namespace lanthorn::tools
