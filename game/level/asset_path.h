// Where the game's files are.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn::game {

// The path of `file` (as it is named from assets/ on, "levels/shutter.glb"): in the folder that
// LANTHORN_ASSETS names, else in the installation, else in the source tree. It need not be there.
std::string asset_path(std::string_view file);

}  // namespace lanthorn::game
