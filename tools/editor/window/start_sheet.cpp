// How the editor begins.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <ctime>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/sheets.h"

namespace lanthorn::edit_window {

namespace fs = std::filesystem;

namespace {

constexpr float kCard = 168;  // units, at least, that a card is wide

std::string ago(double seconds) {
    const double now = static_cast<double>(std::time(nullptr));
    const double minutes = (now - seconds) / 60;
    return minutes < 1         ? "just now"
           : minutes < 90      ? fmt::format("{:.0f} minutes ago", minutes)
           : minutes < 60 * 36 ? fmt::format("{:.0f} hours ago", minutes / 60)
                               : fmt::format("{:.0f} days ago", minutes / 60 / 24);
}

// A scene as a picture with its name; returns whether it was clicked.
bool card(EditorState& state, const fs::path& file, float width) {
    const float u = state.unit, line = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = width * 9 / 16;
    ImGui::PushID(file.c_str());
    const bool clicked = ImGui::InvisibleButton("card", {width, height + line});
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    if (hovered) {
        ImGui::SetTooltip("%s", file.c_str());
    }
    if (!ImGui::IsItemVisible()) {
        return clicked;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner(at.x + width, at.y + height);
    if (const gpu::Texture* picture = state.cards.of(file)) {
        const auto id = image_of(picture->id());
        list.AddImage(id, at, corner);
    } else {
        list.AddRectFilled(at, corner, colour::bar);
        const char* words = "no picture yet";
        const ImVec2 size = ImGui::CalcTextSize(words);
        list.AddText({at.x + (width - size.x) / 2, at.y + (height - size.y) / 2}, colour::faint, words);
    }
    list.AddRect(at, corner, hovered ? colour::chosen : colour::bar, 0, 0, hovered ? 2 * u : 1);
    list.PushClipRect({at.x, corner.y}, {corner.x, corner.y + line}, true);
    const std::string name = file.stem().string();
    list.AddText({at.x + 2 * u, corner.y + 2 * u}, hovered ? colour::chosen : colour::words, name.c_str());
    list.PopClipRect();
    return clicked;
}

// As many in a row as there is room for.
void cards(EditorState& state, const char* words, const std::vector<fs::path>& files, std::size_t most) {
    if (files.empty()) {
        return;
    }
    ImGui::Spacing();
    ImGui::TextDisabled("%s", words);
    const float space = 8 * state.unit, room = ImGui::GetContentRegionAvail().x;
    const auto row = static_cast<std::size_t>(std::max(2.0f, (room + space) / (kCard * state.unit + space)));
    const float width = (room + space) / static_cast<float>(row) - space;
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i) {
        if (i % row != 0) {
            ImGui::SameLine(0, space);
        }
        if (card(state, files[i], width)) {
            state.open(files[i]);
        }
    }
}

}  // namespace

void draw_start(EditorState& state) {
    begin_sheet(state, "start", 940, 660);
    ImGui::TextUnformatted("Lanthorn");
    ImGui::SameLine();
    ImGui::TextDisabled("light a level, and see the game's light while you drag");
    if (state.session.is_open()) {
        const float wide = ImGui::CalcTextSize("Back").x + 2 * ImGui::GetStyle().FramePadding.x;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - wide);
        if (ImGui::Button("Back")) {
            state.sheet = Sheet::none;
        }
    }
    ImGui::Spacing();
    for (const editor::LeftLog& log : state.left_logs) {
        ImGui::PushID(log.log.c_str());
        ImGui::PushStyleColor(ImGuiCol_Text, colour::chosen);
        ImGui::TextUnformatted(fmt::format("{}: {} unsaved edit{}, {}",
                                           log.edited.empty() ? "a new room" : log.edited.filename().string(),
                                           log.steps, log.steps == 1 ? "" : "s", ago(log.seconds))
                                   .c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine();
        if (ImGui::SmallButton("Take them up")) {
            state.sheet = Sheet::none;
            state.desk.act([&state, file = log.log](editor::EditSession& session) {
                const editor::Rebased done = session.recover(file);
                state.opened = true;
                state.toast_until = 1e18;
                state.toast =
                    fmt::format("{} edits taken up{}", done.kept,
                                done.left.empty() ? "" : fmt::format(", {} no longer fit", done.left.size()));
            });
        }
        ImGui::SameLine();
        if (ImGui::SmallButton("Discard")) {
            std::error_code error;
            fs::remove(log.log, error);
            std::erase_if(state.left_logs,
                          [&](const editor::LeftLog& other) { return other.log == log.log; });
            ImGui::PopID();
            break;
        }
        ImGui::PopID();
    }
    ImGui::Spacing();
    const float height = 2.2f * ImGui::GetFrameHeight();
    const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    ImGui::BeginDisabled();
    ImGui::Button("Drop a .glb here", {width, height});
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("Open...", {width, height})) {
        state.act(Act::open);
    }
    ImGui::SameLine();
    if (ImGui::Button("New room", {width, height})) {
        state.act(Act::new_room);
    }
    if (!state.problem.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::bad);
        ImGui::TextWrapped("%s", state.problem.c_str());
        ImGui::PopStyleColor();
    }
    cards(state, "Recent", state.recent, 5);
    cards(state, "Levels of the game", state.levels, state.levels.size());
    ImGui::End();
}

}  // namespace lanthorn::edit_window
