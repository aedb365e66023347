// The subcommands of `lanthorn replay`. Each adds itself and returns what to call if it was chosen.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_replay_accept(CLI::App& replay);
Command add_replay_adopt(CLI::App& replay);
Command add_replay_bisect(CLI::App& replay);
Command add_replay_info(CLI::App& replay);
Command add_replay_pack(CLI::App& replay);
Command add_replay_play(CLI::App& replay);
Command add_replay_record(CLI::App& replay);
Command add_replay_solve(CLI::App& replay);
Command add_replay_state(CLI::App& replay);  // hidden: what bisect and trim ask of another build
Command add_replay_suite(CLI::App& replay);
Command add_replay_suite_slice(CLI::App& replay);  // hidden: a task of a farm
Command add_replay_trim(CLI::App& replay);
Command add_replay_verify(CLI::App& replay);

}  // namespace lanthorn::tools
