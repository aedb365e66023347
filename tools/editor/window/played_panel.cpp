// What was changed in play: rows that are kept by a tick.
#include <imgui.h>

#include <algorithm>

#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

void draw_played(EditorState& state) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Stood otherwise when play ended:");
    ImGui::SameLine();
    const bool some = std::ranges::any_of(state.played, &PlayedRow::keep);
    ImGui::BeginDisabled(!some || state.session.in_gesture());
    const bool keeps = ImGui::Button("Keep what is ticked");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool drops = ImGui::Button("Leave all as it was");
    if (keeps) {
        std::vector<std::string> lines;
        for (const PlayedRow& row : state.played) {
            if (row.keep) {
                lines.insert(lines.end(), row.change.lines.begin(), row.change.lines.end());
            }
        }
        state.run("keep what was changed in play", std::move(lines));
        std::erase_if(state.played, [](const PlayedRow& row) { return row.keep; });
    } else if (drops) {
        state.played.clear();
    }
    if (state.played.empty()) {
        state.drawer_tab = kLightsTab;
        return;
    }
    int id = 0;
    for (PlayedRow& row : state.played) {
        ImGui::PushID(id++);
        ImGui::Checkbox("##keep", &row.keep);
        ImGui::SameLine();
        if (ImGui::Selectable(row.change.title.c_str(), state.selected(row.change.node))) {
            state.reveal = row.change.node;
            state.select({row.change.node});
        }
        ImGui::PopID();
    }
}

}  // namespace lanthorn::edit_window
