// lamplighter, the game, which shows and records what these commands do without a picture.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::tools {

// Becomes the game, with these arguments: does not return. Throws InputError where it lies neither beside
// this program nor in its build folder.
[[noreturn]] void become_game(std::vector<std::string> arguments);

}  // namespace lanthorn::tools
