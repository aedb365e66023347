// Light wishes: the list, and what solving may alter.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cstring>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/light_sensor.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/window/panels.h"
#include "tools/editor/window/quantity.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::edit_window {

using workbench::lux_text;

namespace {

// True once other lux than these are typed.
bool lux_field(const char* id, std::string& lux, float width) {
    std::array<char, 32> buffer{};
    std::strncpy(buffer.data(), lux.c_str(), buffer.size() - 1);
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(id, buffer.data(), buffer.size(), ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("lux: 200, at most <=5, at least >=100");
    }
    const bool changed = lux != buffer.data();
    lux = buffer.data();
    return changed;
}

void add(EditorState& state, const std::string& where) {
    try {
        state.wishes.rows.push_back({editor::wish_of(where, state.wishes.lux), {}});
        ++state.wishes.edition;
    } catch (const Error& error) {
        state.problem = error.what();
    }
}

// What of the chosen nodes a wish can be about.
std::vector<std::string> chosen_places(EditorState& state) {
    std::vector<std::string> paths;
    for (const std::uint32_t node : state.chosen) {
        const ecs::Entity e = state.session.entity_of(node);
        if (e != ecs::kNullEntity && (state.session.world().try_get<LightSensor>(e) != nullptr ||
                                      state.session.world().try_get<LightContract>(e) != nullptr)) {
            paths.push_back(state.session.path_of(node));
        }
    }
    return paths;
}

void draw_head(EditorState& state) {
    WishesShown& wishes = state.wishes;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("A wish for");
    ImGui::SameLine();
    lux_field("##lux", wishes.lux, 70 * state.unit);
    ImGui::SameLine();
    ImGui::TextUnformatted("lx:");
    ImGui::SameLine();
    const bool placing = wishes.placing;
    if (placing) {
        ImGui::PushStyleColor(ImGuiCol_Button, colour::chosen_row);
    }
    if (ImGui::Button(placing ? "drag in the picture ..." : "on a surface")) {
        wishes.placing = !wishes.placing;
    }
    if (placing) {
        ImGui::PopStyleColor();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("in the picture: press on a surface, drag to the rim (Esc ends it)");
    }
    ImGui::SameLine();
    const std::vector<std::string> chosen = chosen_places(state);
    ImGui::BeginDisabled(chosen.empty());
    if (ImGui::Button("at what is chosen")) {
        for (const std::string& path : chosen) {
            add(state, path);
        }
    }
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::SetTooltip("a node with a light_sensor, or with the box of a light_contract");
    }
    ImGui::SameLine(0, 18 * state.unit);
    ImGui::BeginDisabled(wishes.rows.empty() || wishes.solve || state.session.in_gesture());
    if (ImGui::Button("Solve")) {
        wishes.solve = true;
    }
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::SetTooltip("alters intensities of lamps that are not kept, as one step");
    }
    if (wishes.busy) {
        ImGui::SameLine();
        ImGui::TextDisabled(wishes.solve ? "solving ..." : "looking ...");
    }
}

std::string place_words(const editor::LightWish& wish) {
    if (wish.of_node) {
        return wish.where;
    }
    return fmt::format("{:.2f} {:.2f} {:.2f}, {} m round", wish.place.x, wish.place.y, wish.place.z,
                       shown_number(wish.radius, 2));
}

void draw_row(EditorState& state, WishRow& row, bool& gone) {
    WishesShown& wishes = state.wishes;
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(place_words(row.wish).c_str());
    if (ImGui::IsItemClicked() && row.wish.of_node) {
        const std::uint32_t node = editor::find_node(state.session.model(), row.wish.where);
        state.reveal = node;
        state.select(node == kNone ? std::vector<std::uint32_t>() : std::vector{node});
    }
    ImGui::TableNextColumn();
    std::string asked = asked_words(row.wish);
    asked.resize(asked.size() - 3);  // without its unit
    if (lux_field("##asked", asked, ImGui::GetContentRegionAvail().x)) {
        try {
            const editor::LightWish other = editor::wish_of("/", asked);
            row.wish.asks = other.asks;
            row.wish.lux = other.lux;
            ++wishes.edition;
        } catch (const Error&) {  // not yet a number: what was asked stays
        }
    }
    const bool old = wishes.old(state.session.version());
    ImGui::TableNextColumn();
    if (row.found) {
        const bool met = row.found->met_with(row.found->before);
        const ImU32 shade = old ? colour::faint : met ? colour::good : colour::warning;
        const double missed = row.found->missed_with(row.found->before);
        ImGui::PushStyleColor(ImGuiCol_Text, shade);
        ImGui::TextUnformatted(
            row.found->places == 0 ? "no surface"
            : met                  ? fmt::format("{} met", lux_text(row.found->before)).c_str()
                  : fmt::format("{} missed by {:.0f} %", lux_text(row.found->before), 100 * missed).c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s%s", old ? "before the last change: " : "",
                              outcome_words(*row.found).c_str());
        }
    } else {
        ImGui::TextDisabled("?");
    }
    ImGui::TableNextColumn();
    if (ImGui::SmallButton("x")) {
        gone = true;
    }
}

void draw_list(EditorState& state) {
    WishesShown& wishes = state.wishes;
    if (!ImGui::BeginTable("wishes", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("where", 0, 2);
    ImGui::TableSetupColumn("asked lx", 0, 0.8f);
    ImGui::TableSetupColumn("has lx", 0, 1.4f);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 20 * state.unit);
    ImGui::TableHeadersRow();
    std::size_t gone = wishes.rows.size();
    for (std::size_t i = 0; i < wishes.rows.size(); ++i) {
        ImGui::TableNextRow();
        ImGui::PushID(static_cast<int>(i));
        bool goes = false;
        draw_row(state, wishes.rows[i], goes);
        gone = goes ? i : gone;
        ImGui::PopID();
    }
    ImGui::EndTable();
    if (gone < wishes.rows.size()) {
        wishes.rows.erase(wishes.rows.begin() + static_cast<std::ptrdiff_t>(gone));
        ++wishes.edition;
    }
}

void draw_kept(EditorState& state) {
    ImGui::TextDisabled("lamps that stay");
    for (const editor::LightRow& light : state.lights) {
        if (light.node == kNone) {
            continue;
        }
        bool kept = state.wishes.kept.contains(light.node);
        // "lamp#12" where several are called so.
        const std::string name = light.path.substr(light.path.rfind('/') + 1);
        if (ImGui::Checkbox(fmt::format("{}##{}", name, light.node).c_str(), &kept)) {
            kept ? void(state.wishes.kept.insert(light.node)) : void(state.wishes.kept.erase(light.node));
            ++state.wishes.edition;
        }
    }
}

}  // namespace

void draw_wishes(EditorState& state) {
    draw_head(state);
    if (state.wishes.rows.empty()) {
        ImGui::TextDisabled("How bright it shall be where: the lamps' intensities follow.");
        return;
    }
    if (ImGui::BeginTable("sides", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("list", 0, 3);
        ImGui::TableSetupColumn("kept", 0, 1);
        ImGui::TableNextColumn();
        draw_list(state);
        ImGui::TableNextColumn();
        draw_kept(state);
        ImGui::EndTable();
    }
}

}  // namespace lanthorn::edit_window
