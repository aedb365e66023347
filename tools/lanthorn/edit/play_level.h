// The edited scene as a level of lamplighter, played from where the editor looks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"

namespace lanthorn::tools {

// The document with its player where the session looks from, and looking that way. A scene without a player
// gets one, and surfaces to stand on: whatever has a mesh and no collider or body stands still and is solid.
GltfDocument play_document(const editor::EditSession& session);

// Writes that as `level` and gives the command line that plays it: Esc ends it. Throws InputError where the
// game is not installed beside this program.
std::vector<std::string> play_command(const editor::EditSession& session, const Settings& settings,
                                      const std::filesystem::path& level, ivec2 size);

}  // namespace lanthorn::tools
