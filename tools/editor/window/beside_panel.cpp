// What was expected beside what was found: rows of fields, and ghosts in the picture.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

namespace {

constexpr ImU32 kGhost = IM_COL32(0x8f, 0xd8, 0xff, 255), kGhostEdge = IM_COL32(0, 0, 0, 160);
constexpr double kDash = 0.06;  // of an edge

// The corner of a box by three bits: which of them is its upper bound.
dvec3 corner(const Aabb& box, int bits) {
    return {(bits & 1) != 0 ? box.upper.x : box.lower.x, (bits & 2) != 0 ? box.upper.y : box.lower.y,
            (bits & 4) != 0 ? box.upper.z : box.lower.z};
}

}  // namespace

void EditorState::show_beside(BesideShown shown) {
    beside = std::move(shown);
    splits.drawer_open = true;
    drawer_tab = kBesideTab;
    const auto first = std::ranges::find_if(beside.rows, [](const BesideRow& r) { return r.node != kNone; });
    if (first != beside.rows.end()) {
        reveal = first->node;
        select({first->node});
    }
}

void draw_beside(EditorState& state) {
    const BesideShown& beside = state.beside;
    ImGui::TextUnformatted(beside.title.c_str());
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kGhost), "dashed: where it was expected");
    if (!ImGui::BeginTable("beside", 3, ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("Field", 0, 1.8f);
    ImGui::TableSetupColumn("Found");
    ImGui::TableSetupColumn("Expected");
    ImGui::TableHeadersRow();
    int id = 0;
    for (const BesideRow& row : beside.rows) {
        ImGui::PushID(id++);
        ImGui::TableNextColumn();
        const bool on = row.node != kNone && state.selected(row.node);
        if (ImGui::Selectable(row.name.c_str(), on, ImGuiSelectableFlags_SpanAllColumns) &&
            row.node != kNone) {
            state.reveal = row.node;
            state.select({row.node});
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.found.c_str());
        ImGui::TableNextColumn();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kGhost), "%s", row.expected.c_str());
        ImGui::PopID();
    }
    ImGui::EndTable();
    if (beside.more) {
        ImGui::TextDisabled("and more: lanthorn replay bisect --all");
    }
}

void Viewport::draw_beside_ghosts() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const auto& moved : state_.beside.to_expected) {
        const dmat4& to_expected = moved.second;
        const Aabb box = bounds_of(moved.first);
        if (box.empty()) {
            continue;
        }
        const auto ghost = [&](int bits) {
            return dvec3(to_expected * dvec4(origin_ + corner(box, bits), 1));
        };
        for (int from = 0; from < 8; ++from) {
            for (const int axis : {1, 2, 4}) {
                if ((from & axis) != 0) {
                    continue;
                }
                const dvec3 a = ghost(from), b = ghost(from | axis);
                for (double t = 0; t < 1; t += 2 * kDash) {
                    const auto dash = eye_.line(glm::mix(a, b, t), glm::mix(a, b, std::min(t + kDash, 1.0)));
                    if (dash) {
                        list.AddLine(im(dash->first), im(dash->second), kGhostEdge, 3.5f);
                        list.AddLine(im(dash->first), im(dash->second), kGhost, 2.0f);
                    }
                }
            }
        }
    }
}

}  // namespace lanthorn::edit_window
