// The levels of the game, in the order of play.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "game/rules/components.h"

namespace lanthorn::game {

// Stems of their files in assets/levels/.
std::span<const std::string_view> campaign();

// Where the file of a level is: in LANTHORN_ASSETS, else as the installation has it, else the source tree.
std::string level_path(std::string_view stem);

// What a level's file says of it, without loading its meshes and pictures: for lists of levels. Throws
// InputError, naming the file, if it cannot be read, is not binary glTF, or says something else than
// docs/levels.md allows. Empty for a file that says nothing. Cost: reads the file's JSON, a few milliseconds.
LevelInfo read_level_info(const std::string& path);

}  // namespace lanthorn::game
