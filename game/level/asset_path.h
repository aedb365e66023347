// Where the game's files are.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn::game {

// The path of `file` (as it is named from assets/ on, "levels/shutter.glb"): in the folder that
// LANTHORN_ASSETS names, else in the installation, else in the source tree. It need not be there.
std::string asset_path(std::string_view file);

// The program's icon of `side` pixels (48, 128, 256), where the installation or the source tree has it.
std::string icon_path(int side);

}  // namespace lanthorn::game
