// Which keys do what: the keymap `standard`, as Unity, Unreal and Godot have it, and `blender`, as Blender
// has it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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
    go_to_view,  // of nine in a row: use view_number()
    go_to_view_9 = go_to_view + 8,
    keep_view,  // likewise
    keep_view_9 = keep_view + 8,
    view_before,
    view_after,
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
    view_error,
    view_depth,
    view_next_debug,
    reference,
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
    why_light,
    compare,
    compare_technique,
    compare_menu,
    review,
    copy_render_line,
    play,
    play_clip,
    still_solvable,
    move_now,  // at once, without a button that is held
    rotate_now,
    scale_now,
};

enum class Keymap { standard, blender };

struct KeyBinding {
    Act act;
    int key = 0, modifiers = 0;  // GLFW's
    const char* words;           // what it does
    int count = 1;               // so many keys in a row are for so many acts in a row
};

// By its name, as a user's file keeps it, and back. Throws InputError naming `source` for another.
std::string_view name_of(Keymap keymap);
Keymap keymap_named(std::string_view name, std::string_view source);

// Of the keymap. Fly keys are not among them: they work while the right button is held.
std::vector<KeyBinding> bindings(Keymap keymap);
// The act of a key; none where it has none.
Act act_of(Keymap keymap, int key, int modifiers);
// "Ctrl+Shift+S", of the first key that an act has; empty: it has none.
std::string key_name(Keymap keymap, Act act);
std::string key_name(int key, int modifiers);
std::string key_name(const KeyBinding& binding);  // "Ctrl+1 to 9" of several
// Which of the nine acts from `first` on (go_to_view, keep_view) it is, from 1; 0: none of them.
int view_number(Act act, Act first);

}  // namespace lanthorn::edit_window
