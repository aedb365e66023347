// Still solvable? What a recorded session does in the level as it is now.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "tools/editor/core/node_path.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

void draw_solving(EditorState& state) {
    const SolveShown& found = state.solve;
    ImGui::AlignTextToFramePadding();
    if (state.solving) {
        ImGui::ProgressBar(static_cast<float>(found.share), {180 * state.unit, 0},
                           fmt::format("playing, {:.0f} %", 100 * found.share).c_str());
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) {
            state.act(Act::still_solvable);
        }
    } else if (ImGui::Button("Still solvable?")) {
        state.act(Act::still_solvable);
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "plays the level's recording with light sensors that read the scene as it is now (%s)",
            key_name(state.keymap, Act::still_solvable).c_str());
    }
    if (!found.solved) {
        ImGui::SameLine();
        ImGui::TextDisabled("%s", state.solving ? "in a process of its own" : "not asked yet");
        return;
    }
    const bool old = state.solve_version != state.session.version();
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, old ? colour::faint : *found.solved ? colour::good : colour::bad);
    ImGui::TextWrapped("%s%s", old ? "before the last edits: " : "", found.words.c_str());
    ImGui::PopStyleColor();
    int id = 0;
    for (const SolveShown::Row& row : found.rows) {
        ImGui::PushID(id++);
        ImGui::PushStyleColor(ImGuiCol_Text, row.kept ? colour::words : colour::warning);
        if (ImGui::Selectable((std::string(row.kept ? "+ " : "! ") + row.words).c_str()) &&
            !row.node.empty()) {
            for (const std::uint32_t node : state.session.model().in_order()) {
                if (state.session.model().node(node).name == row.node) {
                    state.reveal = node;
                    state.select({node});
                    break;
                }
            }
        }
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
}

}  // namespace lanthorn::edit_window
