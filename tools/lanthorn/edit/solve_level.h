// Whether an edited level can still be solved.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/solve_shown.h"

namespace lanthorn::tools {

// As EditorOptions::solve and EditorOptions::solve_found: by `lanthorn replay solve`, with the recording of
// the level's name.
std::vector<std::string> solve_command(const editor::EditSession& session,
                                       const std::filesystem::path& folder);
edit_window::SolveShown solve_found(const std::filesystem::path& folder);

// The same at once, for scripts.
editor::EditScript::Solved solve_now(const editor::EditSession& session,
                                     const std::filesystem::path& recording);

}  // namespace lanthorn::tools
