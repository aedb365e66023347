#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "tools/editor/core/node_path.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

using editor::EditModel;
using editor::ModelNode;

namespace {

struct Row {
    std::uint32_t node;
    int depth;
    bool open, leaf;
};

// Nodes that the user has folded: open is what people expect of a small scene.
std::set<std::uint32_t>& folded() {
    static std::set<std::uint32_t> nodes;
    return nodes;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

void add_rows(const EditModel& model, std::uint32_t node, int depth, std::vector<Row>& rows) {
    const ModelNode* found = model.find(node);
    if (found == nullptr) {
        return;
    }
    const bool open = !folded().contains(node);
    rows.push_back({node, depth, open, found->children.empty()});
    if (open) {
        for (const std::uint32_t child : found->children) {
            add_rows(model, child, depth + 1, rows);
        }
    }
}

// What kind of thing it is: a small drawing, so that no letter stands for it.
void draw_kind(ImDrawList& list, ImVec2 at, float size, const ModelNode& node, ImU32 shade) {
    const ImVec2 c(at.x + size / 2, at.y + size / 2);
    const float r = size * 0.3f;
    if (node.light != kNone) {
        list.AddCircleFilled(c, r, IM_COL32(255, 210, 110, 255), 12);
    } else if (node.camera != kNone) {
        list.AddRectFilled({c.x - r, c.y - r * 0.7f}, {c.x + r * 0.3f, c.y + r * 0.7f}, shade);
        list.AddTriangleFilled({c.x + r * 0.3f, c.y}, {c.x + r, c.y - r * 0.7f}, {c.x + r, c.y + r * 0.7f},
                               shade);
    } else if (node.mesh != kNone) {
        list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, shade, 0, 0, 1.5f);
    } else {
        list.AddLine({c.x - r, c.y}, {c.x + r, c.y}, shade, 1);
        list.AddLine({c.x, c.y - r}, {c.x, c.y + r}, shade, 1);
    }
}

void click(EditorState& state, const std::vector<Row>& rows, std::size_t i) {
    const ImGuiIO& io = ImGui::GetIO();
    const std::uint32_t node = rows[i].node;
    std::vector<std::uint32_t> chosen = state.chosen;
    if (io.KeyShift && state.range_from != kNone) {
        const auto from = std::ranges::find(rows, state.range_from, &Row::node);
        if (from != rows.end()) {
            const auto a = static_cast<std::size_t>(from - rows.begin());
            chosen.clear();
            for (std::size_t k = std::min(a, i); k <= std::max(a, i); ++k) {
                chosen.push_back(rows[k].node);
            }
        }
    } else if (io.KeyCtrl) {
        const auto at = std::ranges::find(chosen, node);
        at == chosen.end() ? chosen.push_back(node) : static_cast<void>(chosen.erase(at));
        state.range_from = node;
    } else {
        chosen = {node};
        state.range_from = node;
    }
    state.select(std::move(chosen));
}

void draw_row(EditorState& state, const std::vector<Row>& rows, std::size_t i, bool flat) {
    const EditModel& model = state.session.model();
    const Row& row = rows[i];
    const ModelNode& node = model.node(row.node);
    const float u = state.unit, height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float indent = flat ? 0 : static_cast<float>(row.depth) * 12 * u;
    ImGui::PushID(static_cast<int>(row.node));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool chosen = state.selected(row.node);
    ImGui::InvisibleButton("row", {width, height});
    const bool hot = ImGui::IsItemHovered();
    if (chosen || hot) {
        list.AddRectFilled(at, {at.x + width, at.y + height},
                           chosen ? colour::chosen_row : IM_COL32(255, 255, 255, 14));
    }
    const bool shown = model.is_shown(row.node);
    const ImU32 shade = !shown ? IM_COL32(0x78, 0x78, 0x78, 255) : colour::words;
    float x = at.x + indent + 2 * u;
    const float eye = at.x + width - height;
    if (ImGui::IsItemClicked(0)) {
        const float mouse = ImGui::GetIO().MousePos.x;
        if (!flat && !row.leaf && mouse >= x && mouse < x + 14 * u) {
            row.open ? static_cast<void>(folded().insert(row.node))
                     : static_cast<void>(folded().erase(row.node));
        } else if (mouse >= eye) {
            const std::string path = state.session.path_of(row.node);
            state.run(node.visible ? "hide " + editor::called(model, row.node)
                                   : "show " + editor::called(model, row.node),
                      {(node.visible ? "hide " : "show ") + editor::word(path)});
        } else {
            click(state, rows, i);
        }
    }
    if (hot && ImGui::IsMouseDoubleClicked(0) && ImGui::GetIO().MousePos.x < eye) {
        state.act(Act::frame_selection);
    }
    const float middle = at.y + height / 2;
    if (!flat && !row.leaf) {
        const float r = 3.5f * u;
        if (row.open) {
            list.AddTriangleFilled({x + 2 * u, middle - r / 2}, {x + 2 * u + 2 * r, middle - r / 2},
                                   {x + 2 * u + r, middle + r}, colour::faint);
        } else {
            list.AddTriangleFilled({x + 3 * u, middle - r}, {x + 3 * u, middle + r},
                                   {x + 3 * u + 1.5f * r, middle}, colour::faint);
        }
    }
    x += flat ? 0 : 14 * u;
    draw_kind(list, {x, at.y + (height - 16 * u) / 2}, 16 * u, node, shade);
    x += 18 * u;
    list.PushClipRect(at, {eye, at.y + height}, true);
    list.AddText({x, at.y + ImGui::GetStyle().FramePadding.y}, shade,
                 editor::called(model, row.node).c_str());
    list.PopClipRect();
    // The eye: open, or struck through.
    if (hot || !node.visible) {
        const ImVec2 c(eye + height / 2, middle);
        list.AddCircle(c, 4 * u, node.visible ? colour::faint : colour::warning, 12, 1.5f);
        if (!node.visible) {
            list.AddLine({c.x - 5 * u, c.y + 5 * u}, {c.x + 5 * u, c.y - 5 * u}, colour::warning, 1.5f);
        }
    }
    ImGui::PopID();
}

}  // namespace

void draw_tree(EditorState& state) {
    const EditModel& model = state.session.model();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Scene");
    ImGui::SameLine();
    ImGui::TextDisabled("%zu", state.nodes);
    ImGui::SameLine(0, 10 * state.unit);
    std::array<char, 128> buffer{};
    std::strncpy(buffer.data(), state.search.c_str(), buffer.size() - 1);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::InputTextWithHint("##search", "search", buffer.data(), buffer.size())) {
        state.search = buffer.data();
    }
    std::vector<Row> rows;
    const bool flat = !state.search.empty();
    if (flat) {
        const std::string wanted = lower(state.search);
        for (const std::uint32_t node : model.in_order()) {
            if (lower(editor::called(model, node)).find(wanted) != std::string::npos) {
                rows.push_back({node, 0, false, true});
            }
        }
    } else {
        if (state.reveal != kNone && model.find(state.reveal) != nullptr) {
            for (std::uint32_t up = model.node(state.reveal).parent; up != kNone;
                 up = model.node(up).parent) {
                folded().erase(up);
            }
        }
        for (const std::uint32_t root : model.roots) {
            add_rows(model, root, 0, rows);
        }
    }
    ImGui::BeginChild("rows");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    const float height = ImGui::GetFrameHeight();
    if (state.reveal != kNone) {
        const auto at = std::ranges::find(rows, state.reveal, &Row::node);
        if (at != rows.end()) {
            const float y = height * static_cast<float>(at - rows.begin());
            if (y < ImGui::GetScrollY() || y + height > ImGui::GetScrollY() + ImGui::GetWindowHeight()) {
                ImGui::SetScrollY(std::max(0.0f, y - ImGui::GetWindowHeight() / 2));
            }
        }
        state.reveal = kNone;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), height);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_row(state, rows, static_cast<std::size_t>(i), flat);
        }
    }
    clipper.End();
    if (rows.empty()) {
        ImGui::TextDisabled(flat ? " nothing of that name" : " nothing yet: drop a .glb here");
    }
    for (const ecs::Entity guest : state.session.guests()) {
        (void)guest;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRect(at, {at.x + width, at.y + height}, true);
        for (float x = -height; x < width; x += 10 * state.unit) {
            list.AddLine({at.x + x, at.y + height}, {at.x + x + height, at.y}, IM_COL32(255, 176, 64, 46), 3);
        }
        list.PopClipRect();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 4 * state.unit);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("guest light: not in the file");
        ImGui::SameLine(0, 8 * state.unit);
        if (ImGui::SmallButton("adopt")) {
            state.desk.act([](editor::EditSession& session) { session.run("adopt"); });
            state.pace.changed(0, false);
        }
        break;
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace lanthorn::edit_window
