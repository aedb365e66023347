// The drawer below the picture: its tabs, and the panel of the one that is open.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/style.h"

namespace lanthorn::edit_window {

namespace {

struct Tab {
    int number;  // EditorState::drawer_tab
    std::string name;
    const char* short_name;  // where text is large
    void (*draw)(EditorState& state);
};

std::string counted(const char* name, std::size_t count) {
    return fmt::format("{} {}", name, count);
}

// Those that have something to show or to ask.
std::vector<Tab> tabs_of(const EditorState& e) {
    const std::size_t wishes = e.wishes.rows.size();
    std::vector<Tab> tabs = {
        {kLightsTab, counted("Lights", e.lights.size()), "Lights", draw_lights_table},
        {kWarningsTab, counted("Warnings", e.warnings.size()), "Warn", draw_warnings},
        {kWhyTab, "Why", "Why", draw_why},
        {kWishesTab, wishes == 0 ? "Wishes" : counted("Wishes", wishes), "Wish", draw_wishes},
        {kTimelineTab, "Timeline", "Time", draw_timeline}};
    if (e.can_solve) {
        tabs.push_back({kSolveTab, "Solvable", "Solve", draw_solving});
    }
    tabs.push_back({kSettingsTab, "Settings", "Set", draw_settings});
    if (!e.played.empty()) {
        tabs.push_back({kPlayedTab, counted("Played", e.played.size()), "Played", draw_played});
    }
    if (!e.beside.empty()) {
        tabs.push_back({kBesideTab, counted("Beside", e.beside.rows.size()), "Beside", draw_beside});
    }
    return tabs;
}

float button_width(const std::string& name) {
    return ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool tab_button(const char* name, bool on) {
    ImGui::PushStyleColor(ImGuiCol_Button, on ? colour::chosen_row : colour::panel);
    const bool pressed = ImGui::Button(name);
    ImGui::PopStyleColor();
    return pressed;
}

// A row of buttons: ImGui's own tabs would take the room of a closed drawer. Those without room go into a
// menu. Choosing the open one closes the drawer.
void draw_tabs(EditorState& e, std::vector<Tab>& tabs) {
    const bool was_open = e.splits.drawer_open;
    const float gap = 2 * e.unit;
    const auto is_shown = [&](const Tab& tab) { return was_open && e.drawer_tab == tab.number; };
    const auto choose = [&](const Tab& tab) {
        e.splits.drawer_open = !is_shown(tab);
        e.drawer_tab = tab.number;
    };
    float wide = 0;
    for (const Tab& tab : tabs) {
        wide += button_width(tab.name) + gap;
    }
    if (wide > ImGui::GetContentRegionAvail().x) {
        for (Tab& tab : tabs) {
            tab.name = tab.short_name;
        }
    }
    const float edge = ImGui::GetWindowContentRegionMax().x, dots = button_width("...") + gap;
    std::size_t beside = 0;  // how many have room
    for (; beside < tabs.size(); ++beside) {
        const float after = ImGui::GetCursorPosX() + button_width(tabs[beside].name);
        if (after + (beside + 1 == tabs.size() ? 0 : dots) > edge) {
            break;
        }
        if (tab_button(tabs[beside].name.c_str(), is_shown(tabs[beside]))) {
            choose(tabs[beside]);
        }
        ImGui::SameLine(0, gap);
    }
    if (beside < tabs.size()) {
        const std::span<const Tab> more = std::span<const Tab>(tabs).subspan(beside);
        if (tab_button("...", std::ranges::any_of(more, is_shown))) {
            ImGui::OpenPopup("more tabs");
        }
        if (ImGui::BeginPopup("more tabs")) {
            for (const Tab& tab : more) {
                if (ImGui::MenuItem(tab.name.c_str(), nullptr, is_shown(tab))) {
                    choose(tab);
                }
            }
            ImGui::EndPopup();
        }
        ImGui::SameLine(0, gap);
    }
    ImGui::NewLine();
}

}  // namespace

void draw_drawer(EditorState& state) {
    const bool was_open = state.splits.drawer_open;
    std::vector<Tab> tabs = tabs_of(state);
    draw_tabs(state, tabs);
    if (!was_open) {
        return;
    }
    const auto found = std::ranges::find(tabs, state.drawer_tab, &Tab::number);
    ImGui::BeginChild("rows");
    (found == tabs.end() ? tabs.front() : *found).draw(state);
    ImGui::EndChild();
}

}  // namespace lanthorn::edit_window
