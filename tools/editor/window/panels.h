// The panels, each drawn inside an ImGui window of its box. They read the session and ask the desk; nothing
// here writes a component.
#pragma once

#include "tools/editor/window/editor_state.h"

namespace lanthorn::edit_window {

// The scene's nodes, as a tree with a search. Only the rows that are seen are drawn.
void draw_tree(EditorState& state);
// What is chosen: place, light, camera, materials, and every declared component.
void draw_inspector(EditorState& state);
// The light of what is chosen, in candela, lumen, lux and kelvin. Where nothing chosen has one, nothing.
void draw_light(EditorState& state, const std::vector<std::uint32_t>& nodes);
// All lights, a row each, with solo and mute.
void draw_lights_table(EditorState& state);
void draw_history(EditorState& state);
void draw_warnings(EditorState& state);
void draw_settings(EditorState& state);
// Where the light of a point comes from.
void draw_why(EditorState& state);
// How bright it shall be where, and what comes nearest to it.
void draw_wishes(EditorState& state);

// Whether the scene can still be solved.
void draw_solving(EditorState& state);
// Clips, and the moment of one that is shown.
void draw_timeline(EditorState& state);
// What may stand beside the picture (A|B): within a menu.
void draw_compare_menu(EditorState& state);
// What was expected beside what was found.
void draw_beside(EditorState& state);
// What was changed in play.
void draw_played(EditorState& state);

// The tabs of the drawer and, where it is open, the panel of one of them.
void draw_drawer(EditorState& state);
void draw_toolbar(EditorState& state);
void draw_status(EditorState& state);
// What lies over the panels: start, open, save, keys.
void draw_sheet(EditorState& state);

}  // namespace lanthorn::edit_window
