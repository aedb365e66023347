#include "tools/editor/window/keymap.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {

namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT, kAlt = GLFW_MOD_ALT;

constexpr KeyBinding kStandard[] = {
    {Act::tool_select, GLFW_KEY_Q, 0, "select"},
    {Act::tool_move, GLFW_KEY_W, 0, "move"},
    {Act::tool_rotate, GLFW_KEY_E, 0, "rotate"},
    {Act::tool_scale, GLFW_KEY_R, 0, "scale"},
    {Act::axis_x, GLFW_KEY_X, 0, "while dragging: along x"},
    {Act::axis_y, GLFW_KEY_Y, 0, "while dragging: along y; else snapping on or off"},
    {Act::axis_z, GLFW_KEY_Z, 0, "while dragging: along z"},
    {Act::frame_selection, GLFW_KEY_F, 0, "look at what is selected"},
    {Act::frame_selection, GLFW_KEY_KP_DECIMAL, 0, "look at what is selected"},
    {Act::frame_all, GLFW_KEY_F, kShift, "look at everything"},
    {Act::go_to_view, GLFW_KEY_1, 0, "to the view that is kept by that number", 9},
    {Act::keep_view, GLFW_KEY_1, kCtrl, "keep this view by that number", 9},
    {Act::view_before, GLFW_KEY_LEFT, kAlt, "back to the view before"},
    {Act::view_after, GLFW_KEY_RIGHT, kAlt, "forth again"},
    {Act::look_through_game_camera, GLFW_KEY_KP_0, 0, "look through the file's camera"},
    {Act::duplicate, GLFW_KEY_D, kCtrl, "duplicate"},
    {Act::remove, GLFW_KEY_DELETE, 0, "delete"},
    {Act::hide, GLFW_KEY_H, kCtrl, "hide"},
    {Act::show_all, GLFW_KEY_H, kAlt, "show what is hidden"},
    {Act::group, GLFW_KEY_G, kCtrl, "group"},
    {Act::helpers, GLFW_KEY_H, 0, "icons and handles on or off"},
    {Act::undo, GLFW_KEY_Z, kCtrl, "undo"},
    {Act::redo, GLFW_KEY_Y, kCtrl, "redo"},
    {Act::redo, GLFW_KEY_Z, kCtrl | kShift, "redo"},
    {Act::save, GLFW_KEY_S, kCtrl, "save: shows what changes first"},
    {Act::save_as, GLFW_KEY_S, kCtrl | kShift, "save as"},
    {Act::open, GLFW_KEY_O, kCtrl, "open"},
    {Act::new_room, GLFW_KEY_N, kCtrl, "new room"},
    {Act::quit, GLFW_KEY_Q, kCtrl, "quit"},
    {Act::select_all, GLFW_KEY_A, kCtrl, "select everything"},
    {Act::deselect, GLFW_KEY_ESCAPE, 0, "let go; select nothing"},
    {Act::view_final, GLFW_KEY_1, kAlt, "view: final"},
    {Act::view_direct, GLFW_KEY_2, kAlt, "view: direct light"},
    {Act::view_indirect, GLFW_KEY_3, kAlt, "view: indirect light"},
    {Act::view_albedo, GLFW_KEY_4, kAlt, "view: albedo"},
    {Act::view_normals, GLFW_KEY_5, kAlt, "view: normals"},
    {Act::view_coverage, GLFW_KEY_6, kAlt, "view: what the maps see"},
    {Act::view_lux, GLFW_KEY_7, kAlt, "view: lux"},
    {Act::view_error, GLFW_KEY_8, kAlt, "where the indirect light is wrong, and by how much"},
    {Act::reference, GLFW_KEY_9, kAlt, "drawn by the path tracer; again or Esc: as before"},
    {Act::view_next_debug, GLFW_KEY_9, kAlt | kShift, "the technique's next debug view"},
    {Act::view_depth, GLFW_KEY_0, kAlt, "view: depth"},
    {Act::lock_exposure, GLFW_KEY_L, 0, "hold the exposure"},
    {Act::only_picture, GLFW_KEY_SPACE, kCtrl, "nothing but the picture"},
    {Act::help, GLFW_KEY_F1, 0, "these keys"},
    {Act::larger_text, GLFW_KEY_EQUAL, kCtrl, "larger text"},
    {Act::larger_text, GLFW_KEY_EQUAL, kCtrl | kShift, "larger text"},
    {Act::larger_text, GLFW_KEY_KP_ADD, kCtrl, "larger text"},
    {Act::smaller_text, GLFW_KEY_MINUS, kCtrl, "smaller text"},
    {Act::smaller_text, GLFW_KEY_KP_SUBTRACT, kCtrl, "smaller text"},
    {Act::usual_text, GLFW_KEY_0, kCtrl, "text of 100 %"},
    {Act::drop_to_floor, GLFW_KEY_END, 0, "drop to the surface below"},
    {Act::local_axes, GLFW_KEY_T, 0, "axes of the world or its own"},
    {Act::next_panel, GLFW_KEY_F6, 0, "next panel"},
    {Act::check_game, GLFW_KEY_G, 0, "whether the game draws the same"},
    {Act::why_light, GLFW_KEY_I, 0, "why this light is here, under the pointer"},
    {Act::compare, GLFW_KEY_B, 0, "keep this picture beside those that follow (A|B)"},
    {Act::compare_technique, GLFW_KEY_B, kShift, "another technique beside this one (A|B), both of now"},
    {Act::copy_render_line, GLFW_KEY_C, kCtrl | kShift, "copy the command that renders this view"},
    {Act::review, GLFW_KEY_E, kCtrl, "write a page of what the edits change, before and after"},
    {Act::play, GLFW_KEY_F5, 0, "play from here; Esc comes back"},
    {Act::still_solvable, GLFW_KEY_F5, kShift, "whether the level can still be solved; again: no more"},
    {Act::play_clip, GLFW_KEY_SPACE, 0, "play or pause the clip that the timeline shows"},
    {Act::screenshot, GLFW_KEY_F12, 0, "keep a picture of the window"},
};

// Instead of what the keymap `standard` has on these keys, or for these acts.
constexpr KeyBinding kBlender[] = {
    {Act::move_now, GLFW_KEY_G, 0, "move at once; a click or Enter ends it"},
    {Act::rotate_now, GLFW_KEY_R, 0, "rotate at once"},
    {Act::scale_now, GLFW_KEY_S, 0, "scale at once"},
    {Act::remove, GLFW_KEY_X, 0, "delete; while dragging: along x"},
    {Act::remove, GLFW_KEY_DELETE, 0, "delete"},
    {Act::duplicate, GLFW_KEY_D, kShift, "duplicate"},
    {Act::select_all, GLFW_KEY_A, 0, "select everything"},
    {Act::deselect, GLFW_KEY_A, kAlt, "select nothing"},
    {Act::deselect, GLFW_KEY_ESCAPE, 0, "let go; select nothing"},
    {Act::hide, GLFW_KEY_H, 0, "hide"},
    {Act::helpers, GLFW_KEY_H, kShift, "icons and handles on or off"},
    {Act::frame_selection, GLFW_KEY_KP_DECIMAL, 0, "look at what is selected"},
    {Act::frame_all, GLFW_KEY_HOME, 0, "look at everything"},
    {Act::redo, GLFW_KEY_Z, kCtrl | kShift, "redo"},
    {Act::check_game, GLFW_KEY_G, kShift, "whether the game draws the same"},
};

const char* special_name(int key) {
    switch (key) {
        case GLFW_KEY_DELETE:
            return "Del";
        case GLFW_KEY_ESCAPE:
            return "Esc";
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_END:
            return "End";
        case GLFW_KEY_HOME:
            return "Home";
        case GLFW_KEY_LEFT:
            return "Left";
        case GLFW_KEY_RIGHT:
            return "Right";
        case GLFW_KEY_KP_DECIMAL:
            return "Num .";
        case GLFW_KEY_KP_0:
            return "Num 0";
        case GLFW_KEY_KP_ADD:
            return "Num +";
        case GLFW_KEY_KP_SUBTRACT:
            return "Num -";
        case GLFW_KEY_F1:
            return "F1";
        case GLFW_KEY_F5:
            return "F5";
        case GLFW_KEY_F6:
            return "F6";
        case GLFW_KEY_F12:
            return "F12";
        case GLFW_KEY_EQUAL:
            return "+";
        case GLFW_KEY_MINUS:
            return "-";
        default:
            return nullptr;
    }
}

}  // namespace

std::string_view name_of(Keymap keymap) {
    return keymap == Keymap::blender ? "blender" : "standard";
}

Keymap keymap_named(std::string_view name, std::string_view source) {
    const std::string_view word = name.substr(0, name.find('\n'));
    for (const Keymap keymap : {Keymap::standard, Keymap::blender}) {
        if (word == name_of(keymap)) {
            return keymap;
        }
    }
    throw InputError(std::string(source), "line 1",
                     "found '" + std::string(word.substr(0, 40)) + "', expected standard or blender");
}

std::vector<KeyBinding> bindings(Keymap keymap) {
    std::vector<KeyBinding> result;
    if (keymap == Keymap::blender) {
        result.assign(std::begin(kBlender), std::end(kBlender));
    }
    for (const KeyBinding& standard : kStandard) {
        const bool replaced =
            keymap == Keymap::blender && std::ranges::any_of(kBlender, [&](const KeyBinding& other) {
                return other.act == standard.act ||
                       (other.key == standard.key && other.modifiers == standard.modifiers);
            });
        if (!replaced) {
            result.push_back(standard);
        }
    }
    return result;
}

Act act_of(Keymap keymap, int key, int modifiers) {
    const int known = modifiers & (kCtrl | kShift | kAlt);
    for (const KeyBinding& b : bindings(keymap)) {
        if (key >= b.key && key < b.key + b.count && b.modifiers == known) {
            return static_cast<Act>(static_cast<int>(b.act) + key - b.key);
        }
    }
    return Act::none;
}

std::string key_name(int key, int modifiers) {
    std::string name;
    name += (modifiers & kCtrl) != 0 ? "Ctrl+" : "";
    name += (modifiers & kAlt) != 0 ? "Alt+" : "";
    name += (modifiers & kShift) != 0 ? "Shift+" : "";
    if (const char* special = special_name(key)) {
        return name + special;
    }
    return name + static_cast<char>(key);  // letters and digits are their own names
}

std::string key_name(const KeyBinding& binding) {
    const std::string first = key_name(binding.key, binding.modifiers);
    return binding.count == 1 ? first : first + " to " + key_name(binding.key + binding.count - 1, 0);
}

std::string key_name(Keymap keymap, Act act) {
    for (const KeyBinding& b : bindings(keymap)) {
        const int further = static_cast<int>(act) - static_cast<int>(b.act);
        if (further >= 0 && further < b.count) {
            return key_name(b.key + further, b.modifiers);
        }
    }
    return "";
}

int view_number(Act act, Act first) {
    const int further = static_cast<int>(act) - static_cast<int>(first);
    return further >= 0 && further < 9 ? further + 1 : 0;
}

}  // namespace lanthorn::edit_window
