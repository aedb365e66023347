// What lies over the panels.
#pragma once

#include "tools/editor/window/editor_state.h"

namespace lanthorn::edit_window {

// A box in the middle of the window, of so many units, or as large as the window has room for. Then
// ImGui::End(). Returns whether anything of it shows.
bool begin_sheet(EditorState& state, const char* title, float width, float height);
// How the editor begins: files that were open, and the game's levels, each with its picture.
void draw_start(EditorState& state);

}  // namespace lanthorn::edit_window
