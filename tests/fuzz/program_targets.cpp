// The targets of lanthorn_fuzz_programs.
#include <array>

#include "tests/fuzz/commands_target.h"
#include "tests/fuzz/game_target.h"
#include "tests/fuzz/target.h"

namespace lanthorn::fuzz {

std::span<const Target> targets() {
    static constexpr std::array kTargets = {
        Target{"commands", "the command line of lanthorn", run_commands, command_inputs, damage_commands},
        Target{"game", "levels, options, preferences, bindings, progress of lamplighter", read_game,
               game_inputs, damage_game}};
    return kTargets;
}

}  // namespace lanthorn::fuzz
