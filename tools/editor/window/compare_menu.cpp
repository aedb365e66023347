// What may stand beside the picture.
#include <imgui.h>

#include <utility>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/technique.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

void draw_compare_menu(EditorState& state) {
    const bool open = state.session.is_open();
    const editor::DrawnAs* as = state.other_side && state.other_side->as ? &*state.other_side->as : nullptr;
    if (ImGui::MenuItem("This picture, as it is now", key_name(state.keymap, Act::compare).c_str(), false,
                        open && !state.other_side)) {
        state.act(Act::compare);
    }
    if (ImGui::MenuItem("These settings, drawn on", nullptr, false, open)) {
        state.compare_as(state.drawn_as());
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("then change technique, preset or settings: that is B");
    }
    const auto choose = [&](const std::string& words) {
        try {
            state.compare_as(editor::drawn_as(words, as != nullptr ? *as : state.drawn_as()));
        } catch (const Error& error) {
            state.problem = error.what();
        }
    };
    if (ImGui::BeginMenu("Another technique", open)) {
        for (const std::string& name : gi::technique_names()) {
            if (ImGui::MenuItem(name.c_str(), nullptr, as != nullptr && as->technique() == name)) {
                choose(name);
            }
        }
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Another preset", open)) {
        for (const std::string& name : preset_names()) {
            if (ImGui::MenuItem(name.c_str(), nullptr, as != nullptr && as->preset == name)) {
                choose("/" + name);
            }
        }
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Change sides", nullptr, false, as != nullptr)) {
        const editor::DrawnAs now = state.drawn_as();
        state.set_technique(as->technique());
        state.settings = as->settings;
        state.preset = as->preset;
        state.compare_as(now);
    }
    if (ImGui::MenuItem("Nothing beside", key_name(state.keymap, Act::compare).c_str(), false,
                        state.other_side != nullptr)) {
        state.compare(nullptr);
    }
}

}  // namespace lanthorn::edit_window
