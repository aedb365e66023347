// The panels of the window: where they lie and how they are drawn.
#include <chrono>
#include <utility>
#include <vector>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {

enum class Padding { usual, low };  // low: of bars, which do not scroll

// A window of ImGui that fills its box, where it has one. Its ground is painted by paint_panels().
template <class Fill>
void panel(const char* name, const Box& box, float unit, Padding padding, const Fill& fill) {
    if (box.empty()) {
        return;
    }
    const bool low = padding == Padding::low;
    ImGui::SetNextWindowPos({box.x, box.y});
    ImGui::SetNextWindowSize({box.width, box.height});
    if (low) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6 * unit, 2 * unit));
    }
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground |
                     (low ? ImGuiWindowFlags_NoScrollWithMouse : 0));
    if (low) {
        ImGui::PopStyleVar();
    }
    fill();
    ImGui::End();
}

template <class Fill>
void child(const char* name, const Fill& fill) {
    ImGui::BeginChild(name);
    fill();
    ImGui::EndChild();
}

template <class Fill>
void tab(const char* name, const Fill& fill) {
    if (ImGui::BeginTabItem(name)) {
        fill();
        ImGui::EndTabItem();
    }
}

// Scene, inspector and history in one panel.
void draw_side(EditorState& e) {
    if (ImGui::BeginTabBar("tabs")) {
        tab("Scene", [&] { draw_tree(e); });
        tab("Inspector", [&] { child("inspector", [&] { draw_inspector(e); }); });
        tab("History", [&] { child("history", [&] { draw_history(e); }); });
        ImGui::EndTabBar();
    }
}

// Which way a splitter is dragged, and what it sets: the size of the panel before it or behind it.
struct Splitter {
    const char* name;
    const Box& box;
    bool upright;
    float& size;  // units
    float sign;   // of a way right or down
    float usual;
};

void draw_splitter(const Splitter& splitter, EditorState& e, double now) {
    const Box& box = splitter.box;
    if (box.empty()) {
        return;
    }
    ImGui::SetNextWindowPos({box.x, box.y});
    ImGui::SetNextWindowSize({box.width, box.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::bar);
    ImGui::Begin(splitter.name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::InvisibleButton("grip", {box.width, box.height});
    const bool held = ImGui::IsItemActive(), under = ImGui::IsItemHovered();
    if (under || held) {
        ImGui::SetMouseCursor(splitter.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    }
    if (under && ImGui::IsMouseDoubleClicked(0)) {
        splitter.size = splitter.usual;
        e.pace.changed(now, false);
    } else if (held) {
        const ImVec2 way = ImGui::GetIO().MouseDelta;
        const float by = splitter.sign * (splitter.upright ? way.x : way.y) / e.unit;
        if (by != 0) {
            splitter.size += by;
            e.pace.changed(now, true);
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace

void EditorWindow::State::make_panels() {
    EditorState& e = *editor;
    const Layout& at = e.layout;
    grounds.clear();
    const auto made = [&](const char* name, const Box& box, ImU32 ground, Padding padding, const auto& fill) {
        if (!box.empty()) {
            grounds.emplace_back(box, ground);
        }
        panel(name, box, e.unit, padding, fill);
    };
    made("picture", at.picture, colour::surround, Padding::usual, [&] { viewport->draw(now()); });
    made("toolbar", at.toolbar, colour::bar, Padding::low, [&] { draw_toolbar(e); });
    if (at.narrow) {
        made("side", at.right, colour::panel, Padding::usual, [&] { draw_side(e); });
    } else {
        made("tree", at.left, colour::panel, Padding::usual, [&] { draw_tree(e); });
        made("history", at.history, colour::panel, Padding::usual, [&] {
            ImGui::TextDisabled("History");
            child("rows", [&] { draw_history(e); });
        });
        made("inspector", at.right, colour::panel, Padding::usual,
             [&] { child("rows", [&] { draw_inspector(e); }); });
    }
    made("drawer", at.drawer, colour::panel, Padding::low, [&] { draw_drawer(e); });
    made("status", at.status, colour::bar, Padding::low, [&] { draw_status(e); });
    const Splits usual;
    Splits& to = e.splits;
    for (const Splitter& splitter :
         {Splitter{"left splitter", at.left_splitter, true, to.left, 1, usual.left},
          Splitter{"right splitter", at.right_splitter, true, to.right, -1, usual.right},
          Splitter{"drawer splitter", at.drawer_splitter, false, to.drawer, -1, usual.drawer},
          Splitter{"history splitter", at.history_splitter, false, to.history, -1, usual.history}}) {
        draw_splitter(splitter, e, now());
    }
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
