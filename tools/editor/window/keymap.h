// Which keys do what: the keymap `standard`, as Unity, Unreal and Godot have it.
#pragma once

#include <span>
#include <string>

namespace lanthorn::edit_window {

enum class Act {
    none,
    tool_select,
    tool_move,
    tool_rotate,
    tool_scale,
    axis_x,
    axis_y,
    axis_z,
    frame_selection,
    frame_all,
    look_through_game_camera,
    duplicate,
    remove,
    hide,
    show_all,
    group,
    helpers,
    undo,
    redo,
    save,
    save_as,
    open,
    new_room,
    quit,
    select_all,
    deselect,
    view_final,
    view_direct,
    view_indirect,
    view_albedo,
    view_normals,
    view_coverage,
    view_lux,
    view_depth,
    view_next_debug,
    lock_exposure,
    only_picture,
    help,
    larger_text,
    smaller_text,
    usual_text,
    latch_snap,
    drop_to_floor,
    local_axes,
    next_panel,
    screenshot,
    check_game,
};

struct KeyBinding {
    Act act;
    int key = 0, modifiers = 0;  // GLFW's
    const char* words;           // what it does
};

// Of the keymap. Fly keys are not among them: they work while the right button is held.
std::span<const KeyBinding> standard_keymap();
// The act of a key; none where it has none.
Act act_of(int key, int modifiers);
// "Ctrl+Shift+S", of the first key that an act has; empty: it has none.
std::string key_name(Act act);
std::string key_name(int key, int modifiers);

}  // namespace lanthorn::edit_window
