// The edited scene as a level of lamplighter, played from where the editor looks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/played_shown.h"

namespace lanthorn::tools {

// The document with its player where the session looks from, and looking that way. A scene without a player
// gets one, and surfaces to stand on: whatever has a mesh and no collider or body stands still and is solid.
GltfDocument play_document(const editor::EditSession& session);

// Writes that as `level` and gives the command line that plays it, and records that beside it: Esc ends it.
// Throws InputError where the game is not installed beside this program.
std::vector<std::string> play_command(const editor::EditSession& session, const Settings& settings,
                                      const std::filesystem::path& level, ivec2 size);

// What became of the level in that folder: plays the recording again, to its end. Throws InputError where it
// cannot be.
edit_window::PlayedScene played_scene(const std::filesystem::path& folder);

}  // namespace lanthorn::tools
