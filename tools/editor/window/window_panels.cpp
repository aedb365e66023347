// The panels of the window: where they lie and how they are drawn.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

void EditorWindow::State::make_panels() {
    EditorState& e = *editor;
    const float u = e.unit;
    const auto panel = [&](const char* name, const Box& box, ImU32 ground, auto&& fill, bool padded = true) {
        if (box.empty()) {
            return;
        }
        ImGui::SetNextWindowPos({box.x, box.y});
        ImGui::SetNextWindowSize({box.width, box.height});
        grounds.emplace_back(box, ground);
        if (!padded) {
            ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6 * u, 2 * u));
        }
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                         ImGuiWindowFlags_NoBackground | (padded ? 0 : ImGuiWindowFlags_NoScrollWithMouse));
        if (!padded) {
            ImGui::PopStyleVar();
        }
        fill();
        ImGui::End();
    };
    const auto splitter = [&](const char* name, const Box& box, bool upright, float& size, float sign,
                              float usual) {
        if (box.empty()) {
            return;
        }
        ImGui::SetNextWindowPos({box.x, box.y});
        ImGui::SetNextWindowSize({box.width, box.height});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
        ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::bar);
        ImGui::Begin(
            name, nullptr,
            ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
        ImGui::InvisibleButton("grip", {box.width, box.height});
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        }
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
            size = usual;
            e.pace.changed(now(), false);
        } else if (ImGui::IsItemActive()) {
            const ImVec2 way = ImGui::GetIO().MouseDelta;
            const float by = sign * (upright ? way.x : way.y) / u;
            if (by != 0) {
                size += by;
                e.pace.changed(now(), true);
            }
        }
        ImGui::End();
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(2);
    };
    const Splits usual;
    grounds.clear();
    panel("picture", e.layout.picture, colour::surround, [&] { viewport->draw(now()); });
    panel(
        "toolbar", e.layout.toolbar, colour::bar, [&] { draw_toolbar(e); }, false);
    if (e.layout.narrow) {
        panel("side", e.layout.right, colour::panel, [&] {
            if (ImGui::BeginTabBar("tabs")) {
                if (ImGui::BeginTabItem("Scene")) {
                    draw_tree(e);
                    ImGui::EndTabItem();
                }
                if (ImGui::BeginTabItem("Inspector")) {
                    ImGui::BeginChild("inspector");
                    draw_inspector(e);
                    ImGui::EndChild();
                    ImGui::EndTabItem();
                }
                if (ImGui::BeginTabItem("History")) {
                    ImGui::BeginChild("history");
                    draw_history(e);
                    ImGui::EndChild();
                    ImGui::EndTabItem();
                }
                ImGui::EndTabBar();
            }
        });
    } else {
        panel("tree", e.layout.left, colour::panel, [&] { draw_tree(e); });
        panel("history", e.layout.history, colour::panel, [&] {
            ImGui::TextDisabled("History");
            ImGui::BeginChild("rows");
            draw_history(e);
            ImGui::EndChild();
        });
        panel("inspector", e.layout.right, colour::panel, [&] {
            ImGui::BeginChild("rows");
            draw_inspector(e);
            ImGui::EndChild();
        });
    }
    panel(
        "drawer", e.layout.drawer, colour::panel,
        [&] {
            const bool was_open = e.splits.drawer_open;
            // Tabs of buttons: ImGui's would take the room of a closed drawer.
            std::string names[] = {fmt::format("Lights {}", e.lights.size()),
                                   fmt::format("Warnings {}", e.warnings.size()),
                                   "Why",
                                   e.wishes.rows.empty() ? std::string("Wishes")
                                                         : fmt::format("Wishes {}", e.wishes.rows.size()),
                                   "Timeline",
                                   "Solvable",
                                   "Settings",
                                   fmt::format("Played {}", e.played.size()),
                                   fmt::format("Beside {}", e.beside.rows.size())};
            const auto shown = [&](int tab) {
                return (tab != kSolveTab || e.can_solve) && (tab != kPlayedTab || !e.played.empty()) &&
                       (tab != kBesideTab || !e.beside.empty());
            };
            float wide = 0;
            for (int i = kLightsTab; i <= kBesideTab; ++i) {
                wide += shown(i) ? ImGui::CalcTextSize(names[i].c_str()).x +
                                       2 * ImGui::GetStyle().FramePadding.x + 2 * u
                                 : 0;
            }
            if (wide > ImGui::GetContentRegionAvail().x) {  // large text: words alone, and short ones
                constexpr const char* kShort[] = {"Lights", "Warn", "Why",    "Wish",  "Time",
                                                  "Solve",  "Set",  "Played", "Beside"};
                std::ranges::copy(kShort, names);
            }
            const auto choose = [&](int tab) {
                e.splits.drawer_open = !(was_open && e.drawer_tab == tab);
                e.drawer_tab = tab;
            };
            const float edge = ImGui::GetWindowContentRegionMax().x,
                        padding = 2 * ImGui::GetStyle().FramePadding.x;
            const float dots = ImGui::CalcTextSize("...").x + padding;
            std::vector<int> more;  // for which there is no room
            for (int i = kLightsTab; i <= kBesideTab; ++i) {
                if (!shown(i)) {
                    continue;
                }
                const float after =
                    ImGui::GetCursorPosX() + ImGui::CalcTextSize(names[i].c_str()).x + padding;
                bool last = true;
                for (int later = i + 1; later <= kBesideTab; ++later) {
                    last = last && !shown(later);
                }
                if (!more.empty() || after + (last ? 0 : dots + 2 * u) > edge) {
                    more.push_back(i);
                    continue;
                }
                const bool on = was_open && e.drawer_tab == i;
                ImGui::PushStyleColor(ImGuiCol_Button, on ? colour::chosen_row : colour::panel);
                if (ImGui::Button(names[i].c_str())) {
                    choose(i);
                }
                ImGui::PopStyleColor();
                ImGui::SameLine(0, 2 * u);
            }
            if (!more.empty()) {
                const bool on = was_open && std::ranges::find(more, e.drawer_tab) != more.end();
                ImGui::PushStyleColor(ImGuiCol_Button, on ? colour::chosen_row : colour::panel);
                if (ImGui::Button("...")) {
                    ImGui::OpenPopup("more tabs");
                }
                ImGui::PopStyleColor();
                if (ImGui::BeginPopup("more tabs")) {
                    for (const int tab : more) {
                        if (ImGui::MenuItem(names[tab].c_str(), nullptr, was_open && e.drawer_tab == tab)) {
                            choose(tab);
                        }
                    }
                    ImGui::EndPopup();
                }
                ImGui::SameLine(0, 2 * u);
            }
            ImGui::NewLine();
            if (!was_open) {
                return;
            }
            ImGui::BeginChild("rows");
            e.drawer_tab == kLightsTab     ? draw_lights_table(e)
            : e.drawer_tab == kWarningsTab ? draw_warnings(e)
            : e.drawer_tab == kWhyTab      ? draw_why(e)
            : e.drawer_tab == kWishesTab   ? draw_wishes(e)
            : e.drawer_tab == kTimelineTab ? draw_timeline(e)
            : e.drawer_tab == kSolveTab    ? draw_solving(e)
            : e.drawer_tab == kPlayedTab   ? draw_played(e)
            : e.drawer_tab == kBesideTab   ? draw_beside(e)
                                           : draw_settings(e);
            ImGui::EndChild();
        },
        false);
    panel(
        "status", e.layout.status, colour::bar, [&] { draw_status(e, now()); }, false);
    splitter("left splitter", e.layout.left_splitter, true, e.splits.left, 1, usual.left);
    splitter("right splitter", e.layout.right_splitter, true, e.splits.right, -1, usual.right);
    splitter("drawer splitter", e.layout.drawer_splitter, false, e.splits.drawer, -1, usual.drawer);
    splitter("history splitter", e.layout.history_splitter, false, e.splits.history, -1, usual.history);
    draw_sheet(e);
}

// Draws those panels that differ from what the window shows. Their own colours by clearing: blending every
// pixel of a window takes longer than all that is in it.
void EditorWindow::State::paint_panels(ivec2 size) {
    gpu::WindowContext& context = window.context();
    // A GPU draws all of them sooner than they are compared.
    const bool in_parts = window.info().software && context.can_show_parts();
    if (!in_parts || input.uncovered()) {
        painter.forget();
    }
    const auto pictures = static_cast<std::uint64_t>(editor->picture.frames()) + editor->other_pictures;
    const std::vector<Box> parts = painter.paint(overlay.made(), grounds, size, pictures,
                                                 [this](ImDrawData& some) { overlay.draw(some); });
    if (!in_parts) {
        return;
    }
    context.show_parts_alone();
    for (const Box& part : parts) {
        const ivec2 extent(static_cast<int>(part.width), static_cast<int>(part.height));
        context.show_part({static_cast<int>(part.x), size.y - static_cast<int>(part.y) - extent.y}, extent);
    }
}

// The window sleeps while nothing happens, and what it says is to vanish all the same.
void EditorWindow::State::set_alarm() {
    const double until = editor->toast_until, left = until - now();
    if (left > 0 && left < 60 && until != alarm_for) {
        alarm_for = until;
        alarm.set(Alarm::Clock::now() + std::chrono::duration_cast<Alarm::Clock::duration>(
                                            std::chrono::duration<double>(left + 0.01)));
    }
}

void EditorWindow::State::draw_panels(bool in_frame) {
    EditorState& e = *editor;
    const auto begun = std::chrono::steady_clock::now();
    const bool answers = input.urgent();
    const double asked = input.oldest();
    const ivec2 size = window.framebuffer_size();
    if (!in_frame && std::exchange(e.fonts_changed, false)) {
        e.unit = static_cast<float>(e.text_scale);
        e.fonts = apply_editor_style(e.unit);
        overlay.renew_fonts();
        painter.forget();
        e.pace.changed(now(), false);
    }
    const Layout before = e.layout;
    e.layout = lay_out(size, e.unit, e.splits);
    if (!(before.picture == e.layout.picture)) {
        e.pace.changed(now(), false);
    }
    overlay.begin();
    make_panels();
    popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    typing = ImGui::GetIO().WantTextInput;
    const bool fields_held = e.fields.dragging();
    if (fields_held != e.pace.held() && !viewport->gesture()) {
        e.pace.hold(fields_held, now());
    }
    glViewport(0, 0, size.x, size.y);
    paint_panels(size);
    if (report.on()) {
        glFinish();
    }
    ++e.figures.ui_frames;
    e.figures.ui_ms = ms_since(begun);
    last_ui = now();
    input.drawn();
    if (answers) {
        report.answer(1000 * (last_ui - asked), in_frame);
    }
}

}  // namespace lanthorn::edit_window
