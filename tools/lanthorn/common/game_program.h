// lamplighter, the game, which shows and records what these commands do without a picture.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::tools {

// The game's program: beside this one or in its build folder. Throws InputError where it is in neither.
std::string game_program();

// Becomes the game, with these arguments: does not return. Throws InputError where it lies neither beside
// this program nor in its build folder.
[[noreturn]] void become_game(std::vector<std::string> arguments);

}  // namespace lanthorn::tools
