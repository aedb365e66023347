// Target `game`: what lamplighter reads. An input's first byte says which: 'l' a level, 'o' options, one a
// line, 'p' preferences, 'b' bindings, 's' progress.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/mutation.h"

namespace lanthorn::fuzz {

// A level that is one is played for some steps; progress is read as it is and with a right checksum.
void read_game(std::string_view input);
std::vector<std::string> game_inputs();
std::string damage_game(const std::string& input, Mutator& mutator);

}  // namespace lanthorn::fuzz
