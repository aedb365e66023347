// The table of all lights.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tools/editor/window/elide.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/panels.h"
#include "tools/editor/window/quantity.h"

namespace lanthorn::edit_window {

using editor::LightRow;

namespace {

float text_width(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

// A square letter that is on or off.
bool toggle(const char* letter, bool on, ImU32 shade, float size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(letter, {size, size});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner(at.x, at.y + 1);
    if (on) {
        list.AddRectFilled(corner, {corner.x + size - 2, corner.y + size - 2}, shade);
    } else if (ImGui::IsItemHovered()) {
        list.AddRect(corner, {corner.x + size - 2, corner.y + size - 2}, colour::faint);
    }
    const ImVec2 words = ImGui::CalcTextSize(letter);
    list.AddText({at.x + (size - 2 - words.x) / 2, at.y + ImGui::GetStyle().FramePadding.y},
                 on ? IM_COL32(0x10, 0x10, 0x10, 255) : colour::faint, letter);
    return clicked;
}

// A number that is dragged or typed, of all chosen rows or of this one.
void cell(EditorState& state, const LightRow& row, const char* id, double value, std::string_view field,
          const char* suffix, int digits) {
    if (row.node == kNone) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", shown_number(value, digits).c_str());
        return;
    }
    ImGui::PushID(id);
    NumberRow shown{.label = "##drag", .value = value};
    shown.lower = 0;
    shown.digits = digits;
    state.fields.begin(6 * state.unit, state.unit);
    shown.logarithmic = true;
    if (field == "light.colour") {
        shown.lower = 1000;
        shown.upper = 20000;
        shown.step = 0.005;
    } else if (field == "light.range") {
        shown.upper = std::numeric_limits<double>::infinity();
    }
    const NumberChange change = state.fields.number(shown);
    if (change.doing != Doing::nothing) {
        std::vector<std::uint32_t> nodes = {row.node};
        if (state.selected(row.node)) {
            nodes = state.chosen;
        }
        std::vector<std::string> lines;
        for (const std::uint32_t node : nodes) {
            if (editor::light_of(state.session.model(), node) != nullptr) {
                lines.push_back(
                    set_line(state.session.path_of(node), field,
                             json_number(change.value) + (change.unit.empty() ? suffix : change.unit)));
            }
        }
        state.follow(change.doing,
                     fmt::format("{} of {}", id,
                                 nodes.size() == 1 ? row.name : fmt::format("{} lights", nodes.size())),
                     std::move(lines));
    }
    ImGui::PopID();
}

void solo_and_mute(EditorState& state, const LightRow& row, float size) {
    const auto flip = [&](std::set<std::uint32_t>& set) {
        if (!set.erase(row.node)) {
            set.insert(row.node);
        }
        state.pace.changed(0, false);
    };
    ImGui::TableNextColumn();
    if (toggle("S", state.solo.contains(row.node), colour::chosen, size)) {
        flip(state.solo);
    }
    ImGui::SameLine(0, 0);
    if (toggle("M", state.muted.contains(row.node), colour::bad, size)) {
        flip(state.muted);
    }
}

// With its colour before it, and struck out while it is off. A click chooses the light.
void name_cell(EditorState& state, const LightRow& row, float size) {
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const vec3 c = row.colour;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x, at.y + 3}, {at.x + 10 * state.unit, at.y + size - 3},
        ImGui::ColorConvertFloat4ToU32({std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z), 1}));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 14 * state.unit);
    const bool off = state.muted.contains(row.node) || !row.shown ||
                     (!state.solo.empty() && !state.solo.contains(row.node));
    if (off) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::faint);
    }
    const std::string whole = row.node == kNone ? row.name + " (guest)" : row.name;
    const std::string name = elided(whole, ImGui::GetContentRegionAvail().x, text_width);
    ImGui::AlignTextToFramePadding();
    const ImVec2 text(ImGui::GetCursorScreenPos().x,
                      ImGui::GetCursorScreenPos().y + ImGui::GetStyle().FramePadding.y);
    const bool clicked = ImGui::Selectable((name + "##name").c_str(), state.selected(row.node),
                                           ImGuiSelectableFlags_AllowItemOverlap, {0, size});
    if (name != whole && ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", whole.c_str());
    }
    if (clicked && row.node != kNone) {
        std::vector<std::uint32_t> chosen =
            ImGui::GetIO().KeyCtrl ? state.chosen : std::vector<std::uint32_t>();
        std::erase(chosen, row.node);
        chosen.push_back(row.node);
        state.reveal = row.node;
        state.select(std::move(chosen));
    }
    if (off) {
        ImGui::PopStyleColor();
        const float y = text.y + ImGui::GetTextLineHeight() / 2;
        ImGui::GetWindowDrawList()->AddLine({text.x, y}, {text.x + ImGui::CalcTextSize(name.c_str()).x, y},
                                            colour::faint);
    }
}

// Strength, colour and range. What a sun has not is left empty.
void light_cells(EditorState& state, const LightRow& row) {
    const bool directional = row.type == LightType::directional;
    ImGui::TableNextColumn();
    if (!directional) {
        cell(state, row, "intensity", row.candela, "light.intensity", "", 4);
    }
    ImGui::TableNextColumn();
    if (!directional) {
        cell(state, row, "flux", row.lumen, "light.intensity", "lm", 4);
    }
    ImGui::TableNextColumn();
    cell(state, row, "lux", row.lux, "light.intensity", "lx", 4);
    ImGui::TableNextColumn();
    cell(state, row, "temperature", row.kelvin.kelvin, "light.colour", "K", 4);
    ImGui::TableNextColumn();
    if (!directional) {
        cell(state, row, "range", row.range, "light.range", "", 3);
    }
}

// What it costs in a frame of this view, and what it gives of all light that falls on what is seen.
void gain_cells(const EditorState& state, const LightRow& row) {
    const auto found = state.gains.find(row.node);
    const auto cell = [](const std::string& words, bool old, ImU32 shade, const std::string& hint) {
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, old ? colour::faint : shade);
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s%s", old ? "before the last edit: " : "", hint.c_str());
        }
    };
    const bool old =
        state.costs_version != state.session.version() || !(state.costs_pose == state.session.pose());
    const bool timed = found != state.gains.end() && found->second.ms;
    const bool tells = timed && found->second.tells();
    const double noise = timed ? found->second.ms_noise : 0;
    cell(tells   ? fmt::format("{:.1f}", *found->second.ms)
         : timed ? "-"
                 : "?",
         timed && old, tells ? colour::words : colour::faint,
         tells   ? fmt::format("{:.1f} +- {:.1f} ms of a frame of this view", *found->second.ms, noise)
         : timed ? fmt::format("less than {:.1f} ms of a frame of this view: within the noise of measuring",
                               std::max(*found->second.ms, 0.0) + 2 * noise)
                 : std::string("measured when the hand rests"));
    const bool given = found != state.gains.end();
    const double share = given ? found->second.share : 0;
    const bool little = given && share < workbench::kWorthHaving;
    cell(!given                       ? "?"
         : share > 0 && share < 0.001 ? "< 0.1 %"
         : share < 0.1                ? fmt::format("{:.1f} %", 100 * share)
                                      : fmt::format("{:.0f} %", 100 * share),
         given && state.gains_version != state.session.version(), little ? colour::warning : colour::words,
         little ? "hardly any of the light that falls on what is seen here"
                : "of the light that falls on what is seen here");
}

// A column, and how many units it needs. The smaller its rank, the longer it stays where there is little
// room: all of it is in the inspector, too.
struct Column {
    const char* name;
    float units;
    int rank;
};
constexpr std::array<Column, 9> kColumns = {{{"name", 112, 0},
                                             {"cd", 58, 1},
                                             {"lm", 62, 5},
                                             {"lx at 1 m", 68, 6},
                                             {"K", 50, 3},
                                             {"range m", 62, 7},
                                             {"ms", 48, 4},
                                             {"share", 52, 2},
                                             {"kind", 48, 8}}};

// Which of them so many units have room for.
std::array<bool, kColumns.size()> fitting(float units) {
    std::array<bool, kColumns.size()> fits{};
    float left = units - 64;  // solo, mute and the scroll bar
    for (int rank = 0; rank < static_cast<int>(kColumns.size()); ++rank) {
        const auto found = std::ranges::find(kColumns, rank, &Column::rank);
        left -= found->units;
        if (left < 0 && rank > 1) {
            break;
        }
        fits.at(static_cast<std::size_t>(found - kColumns.begin())) = true;
    }
    return fits;
}

}  // namespace

void draw_lights_table(EditorState& state) {
    if (state.lights.empty()) {
        ImGui::TextDisabled("No light in this file. Add > Lamp puts one in.");
        return;
    }
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                       ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingStretchProp;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const std::array<bool, kColumns.size()> fits = fitting(room.x / state.unit);
    // Whole rows: what would be cut at the lower edge is scrolled to.
    const float size = ImGui::GetFrameHeight(), row_height = size + 2 * ImGui::GetStyle().CellPadding.y;
    const float rows = std::max(1.0f, std::floor((room.y - row_height) / row_height));
    if (!ImGui::BeginTable("lights", 1 + static_cast<int>(kColumns.size()), kFlags,
                           {0, (1 + rows) * row_height})) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 2 * size + 4);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        ImGui::TableSetupColumn(kColumns.at(i).name,
                                fits.at(i) ? ImGuiTableColumnFlags_None : ImGuiTableColumnFlags_Disabled,
                                kColumns.at(i).units);
    }
    ImGui::TableHeadersRow();
    int id = 0;
    for (const LightRow& row : state.lights) {
        ImGui::TableNextRow();
        ImGui::PushID(id++);
        solo_and_mute(state, row, size);
        name_cell(state, row, size);
        light_cells(state, row);
        gain_cells(state, row);
        ImGui::TableNextColumn();
        constexpr const char* kKinds[] = {"sun", "point", "spot"};
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", kKinds[static_cast<std::size_t>(row.type)]);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

}  // namespace lanthorn::edit_window
