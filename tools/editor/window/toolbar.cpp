// The toolbar above the picture: menus, tools, and what is drawn.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "lanthorn/gi/technique.h"
#include "tools/editor/window/panels.h"
#include "tools/editor/window/quantity.h"

namespace lanthorn::edit_window {

namespace {

bool item(const char* words, Act act, EditorState& state, bool enabled = true) {
    if (ImGui::MenuItem(words, key_name(state.keymap, act).c_str(), false, enabled)) {
        state.act(act);
        return true;
    }
    return false;
}

// A button that acts, lit while `on`.
void button(EditorState& state, const std::string& name, bool on, Act act, const char* words,
            float width = 0) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0x2f, 0x6a, 0xa8, 255));
    }
    if (ImGui::Button(name.c_str(), {width, 0})) {
        state.act(act);
    }
    if (on) {
        ImGui::PopStyleColor();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words);
    }
}

void tool_button(EditorState& state, const char* letter, Tool tool, const char* words, Act act) {
    button(state, letter, state.tool == tool, act, words, ImGui::GetFrameHeight() * 1.15f);
    ImGui::SameLine(0, 2);
}

void tools(EditorState& state) {
    if (state.keymap == Keymap::blender) {
        tool_button(state, "Sel", Tool::select, "select", Act::tool_select);
        tool_button(state, "G", Tool::move, "handles that move (G: at once)", Act::tool_move);
        tool_button(state, "R", Tool::rotate, "handles that rotate (R: at once)", Act::tool_rotate);
        tool_button(state, "S", Tool::scale, "handles that scale (S: at once)", Act::tool_scale);
    } else {
        tool_button(state, "Q", Tool::select, "select (Q)", Act::tool_select);
        tool_button(state, "W", Tool::move, "move (W)", Act::tool_move);
        tool_button(state, "E", Tool::rotate, "rotate (E)", Act::tool_rotate);
        tool_button(state, "R", Tool::scale, "scale (R)", Act::tool_scale);
    }
}

void add_menu(EditorState& state) {
    const bool open = state.session.is_open();
    // Before the camera, where one looks.
    const workbench::CameraPose pose = state.session.pose();
    const dvec3 at = pose.at + 1.5 * dvec3(transform_of(pose).rotation * vec3(0, 0, -1));
    if (ImGui::MenuItem("Lamp", nullptr, false, open)) {
        state.places = "lamp";
    }
    if (ImGui::MenuItem("Spot", nullptr, false, open)) {
        state.places = "spot";
    }
    if (ImGui::MenuItem("Sun", nullptr, false, open)) {
        state.add_light("sun", "directional", at, glm::normalize(vec3(-0.4f, -1, -0.3f)));
    }
    if (ImGui::MenuItem("Empty node", nullptr, false, open)) {
        state.run("add node", {fmt::format("add-node / node {:.3f} {:.3f} {:.3f}", at.x, at.y, at.z)});
    }
}

// Views to go to, and where this one is kept.
void kept_views_menu(EditorState& state) {
    const std::string file = state.views_file();
    const bool open = state.session.is_open();
    const auto nine = [&](const char* name, Act first, bool only_kept) {
        if (!ImGui::BeginMenu(name, open)) {
            return;
        }
        for (int i = 0; i < KeptViews::kCount; ++i) {
            const bool kept = state.views.find(file, i + 1) != nullptr;
            const Act act = static_cast<Act>(static_cast<int>(first) + i);
            item(fmt::format("{}{}", i + 1, kept ? "" : "  (empty)").c_str(), act, state, kept || !only_kept);
        }
        ImGui::EndMenu();
    };
    nine("Go to view", Act::go_to_view, true);
    nine("Keep this view as", Act::keep_view, false);
    item("View before", Act::view_before, state, open);
    item("View after", Act::view_after, state, open);
}

void view_menu(EditorState& state) {
    const auto view = [&](const char* words, Act act, const char* name) {
        if (ImGui::MenuItem(words, key_name(state.keymap, act).c_str(), state.picture.view() == name)) {
            state.act(act);
        }
    };
    view("Final", Act::view_final, "final");
    view("Direct light", Act::view_direct, "direct");
    view("Indirect light", Act::view_indirect, "indirect");
    view("Albedo", Act::view_albedo, "albedo");
    view("Normals", Act::view_normals, "normals");
    view("Depth", Act::view_depth, "depth");
    view("Lux", Act::view_lux, "lux");
    if (ImGui::MenuItem("Error of the indirect light", key_name(state.keymap, Act::view_error).c_str(),
                        state.error_shown)) {
        state.act(Act::view_error);
    }
    ImGui::Separator();
    if (const gi::TechniqueEntry* entry = gi::find_technique(state.settings.text("gi.technique"))) {
        for (const gi::DebugView& debug : entry->debug_views) {
            if (ImGui::MenuItem(debug.name.c_str(), nullptr, state.picture.view() == debug.name)) {
                state.picture.set_view(state.picture.view() == debug.name ? "final" : debug.name);
                state.pace.changed(0, false);
            }
            if (ImGui::IsItemHovered()) {
                ImGui::SetTooltip("%s shows %s", debug.name.c_str(), debug.docs.c_str());
            }
        }
        if (!entry->debug_views.empty()) {
            ImGui::Separator();
        }
    }
    if (ImGui::BeginMenu("Beside (A|B)", state.session.is_open())) {
        draw_compare_menu(state);
        ImGui::EndMenu();
    }
    item("Copy the command that renders this", Act::copy_render_line, state);
    item("Hold the exposure", Act::lock_exposure, state);
    if (ImGui::MenuItem("Refine what is still", nullptr, &state.refines)) {
        state.settings_changed = true;
    }
    item("Icons and handles", Act::helpers, state);
    item("Look at what is chosen", Act::frame_selection, state);
    item("Look at everything", Act::frame_all, state);
    item("Nothing but the picture", Act::only_picture, state);
    ImGui::Separator();
    kept_views_menu(state);
    ImGui::Separator();
    if (ImGui::BeginMenu("Keys")) {
        for (const Keymap keymap : {Keymap::standard, Keymap::blender}) {
            if (ImGui::MenuItem(std::string(name_of(keymap)).c_str(), nullptr, state.keymap == keymap)) {
                state.keymap = keymap;
            }
        }
        ImGui::EndMenu();
    }
    item("Larger text", Act::larger_text, state);
    item("Smaller text", Act::smaller_text, state);
}

void menus(EditorState& state) {
    const bool open = state.session.is_open();
    const auto menu = [&](const char* name, auto&& fill) {
        if (ImGui::Button(name)) {
            ImGui::OpenPopup(name);
        }
        const ImVec2 below(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y);
        ImGui::SetNextWindowPos(below);
        if (ImGui::BeginPopup(name)) {
            fill();
            ImGui::EndPopup();
        }
        ImGui::SameLine(0, 0);
    };
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    menu("File", [&] {
        item("New room", Act::new_room, state);
        item("Open...", Act::open, state);
        if (ImGui::BeginMenu("Recent", !state.recent.empty())) {
            for (const auto& file : state.recent) {
                if (ImGui::MenuItem(file.c_str())) {
                    state.open(file);
                }
            }
            ImGui::EndMenu();
        }
        ImGui::Separator();
        item("Save...", Act::save, state, open);
        item("Save as...", Act::save_as, state, open);
        ImGui::Separator();
        item("Still solvable?", Act::still_solvable, state, open && state.can_solve);
        item("Keep a picture of the window", Act::screenshot, state);
        item("Quit", Act::quit, state);
    });
    menu("Edit", [&] {
        item("Undo", Act::undo, state, state.session.can_undo());
        item("Redo", Act::redo, state, state.session.can_redo());
        ImGui::Separator();
        const bool some = !state.chosen.empty();
        item("Duplicate", Act::duplicate, state, some);
        item("Delete", Act::remove, state, some);
        item("Group", Act::group, state, some);
        item("Hide", Act::hide, state, some);
        item("Show all", Act::show_all, state, open);
        item("Drop to the surface below", Act::drop_to_floor, state, some);
        ImGui::Separator();
        item("Select everything", Act::select_all, state, open);
    });
    menu("Add", [&] { add_menu(state); });
    menu("View", [&] { view_menu(state); });
    ImGui::PopStyleColor();
}

// A combination that says what is chosen.
template <class Fill>
void combo(const char* id, const std::string& shown, float width, const char* words, Fill&& fill) {
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        fill();
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered() && *words != '\0') {
        ImGui::SetTooltip("%s", words);
    }
    ImGui::SameLine();
}

// Axes of handles, and the step that dragging snaps to.
void snapping(EditorState& state) {
    button(state, state.local_axes ? "own axes" : "world", false, Act::local_axes,
           "axes of handles: the world's or the thing's own (T)");
    ImGui::SameLine();
    button(state, fmt::format("snap {} m", shown_number(state.steps.metres)), state.snap_latched,
           Act::latch_snap,
           "snapping on or off (Y); Ctrl turns it round while dragging. Right click: the step");
    if (ImGui::BeginPopupContextItem("step")) {
        for (const double step : {0.01, 0.05, 0.1, 0.25, 0.5, 1.0}) {
            if (ImGui::MenuItem(fmt::format("{} m", step).c_str(), nullptr, step == state.steps.metres)) {
                state.steps.metres = step;
            }
        }
        ImGui::EndPopup();
    }
}

void exposure(EditorState& state) {
    const bool held = state.exposure_locked;
    if (held) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::warning);
    }
    const bool pressed =
        ImGui::Button(held ? fmt::format("EV {:.1f} held", state.locked_ev).c_str() : "EV auto");
    if (held) {
        ImGui::PopStyleColor();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("holds the exposure, here alone (L)");
    }
    if (pressed) {
        state.act(Act::lock_exposure);
    }
}

void techniques(EditorState& state) {
    for (const std::string& name : gi::technique_names()) {
        if (ImGui::Selectable(name.c_str(), name == state.settings.text("gi.technique"))) {
            state.set_technique(name);
        }
    }
}

void presets(EditorState& state) {
    for (const std::string& name : preset_names()) {
        if (ImGui::Selectable(name.c_str(), name == state.preset)) {
            const std::string technique = state.settings.text("gi.technique");
            Settings fresh(state.settings.schema());
            fresh.apply_preset(name);
            fresh.set_from_text("gi.technique", technique);
            state.settings = fresh;
            state.preset = name;
            state.settings_changed = true;
        }
    }
}

}  // namespace

void draw_toolbar(EditorState& state) {
    const float u = state.unit, width = ImGui::GetIO().DisplaySize.x;
    const bool wide = !state.layout.narrow;
    ImGui::AlignTextToFramePadding();
    menus(state);
    ImGui::SameLine(0, 10 * u);
    tools(state);
    ImGui::SameLine(0, 8 * u);
    // A small window with large text goes without some: keys (T, Y; L) and the menu View have them, too.
    if (width > 760 * u) {
        snapping(state);
    }
    ImGui::SameLine(0, 10 * u);
    combo("##view", state.picture.view(), (wide ? 92 : 82) * u, "what is shown (Alt+1 to 9)",
          [&] { view_menu(state); });
    if (width > 900 * u) {
        button(state, "A|B", state.other_side != nullptr, Act::compare_menu,
               "another technique, preset or time beside this picture (B, Shift+B)");
        ImGui::SameLine();
    }
    if (width > 620 * u) {
        exposure(state);
        ImGui::SameLine();
    }
    button(state, state.playing ? "playing" : "> Play", false, Act::play,
           "the game, from here, in a window of its own (F5)");
    ImGui::SameLine();
    combo("##technique", state.settings.text("gi.technique"), (wide ? 100 : 72) * u,
          "technique of indirect light", [&] { techniques(state); });
    combo("##preset", state.preset, (wide ? 82 : 66) * u, "preset: how much is spent on the picture",
          [&] { presets(state); });
}

}  // namespace lanthorn::edit_window
