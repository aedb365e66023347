#include "tools/editor/window/editor_state.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace lanthorn::edit_window {

namespace {
constexpr double kToast = 4;  // seconds
}

bool EditorState::selected(std::uint32_t node) const {
    return node != kNone && std::ranges::find(chosen, node) != chosen.end();
}

void EditorState::select(std::vector<std::uint32_t> nodes) {
    chosen = nodes;
    desk.act([nodes = std::move(nodes)](editor::EditSession& edited) { edited.select(nodes); });
}

void EditorState::say(const std::string& line, double now) {
    toast = line;
    toast_until = now + kToast;
}

std::string EditorState::views_file() const {
    std::error_code error;
    return session.path().empty()
               ? ""
               : std::filesystem::absolute(session.path(), error).lexically_normal().string();
}

void EditorState::open(const std::filesystem::path& file) {
    sheet = Sheet::none;
    problem.clear();
    desk.act([this, file](editor::EditSession& edited) {
        edited.open(file);
        opened = true;
    });
}

void EditorState::read() {
    if (read_version == session.version()) {
        return;
    }
    read_version = session.version();
    lights = editor::lights_table(session.model());
    nodes = session.model().node_count();
    if (!session.in_gesture()) {
        warnings = editor::edit_warnings(session);
        dirty = session.is_dirty();
    }
    chosen = session.selection();
}

void EditorState::run(const std::string& text, std::vector<std::string> lines) {
    problem.clear();
    desk.run(text, std::move(lines));
    pace.changed(glfwGetTime(), false);
}

void EditorState::preview(const std::string& text, std::vector<std::string> lines) {
    desk.preview(text, std::move(lines));
    pace.changed(glfwGetTime(), true);
}

void EditorState::finish(bool keep) {
    keep ? desk.commit() : desk.cancel();
    pace.changed(glfwGetTime(), true);
}

void EditorState::follow(Doing doing, const std::string& text, std::vector<std::string> lines) {
    switch (doing) {
        case Doing::nothing:
            return;
        case Doing::dragging:
            preview(text, std::move(lines));
            return;
        case Doing::dropped:
            finish(false);
            return;
        case Doing::done:
            if (desk.gesture()) {
                preview(text, std::move(lines));
                finish(true);
            } else {
                run(text, std::move(lines));
            }
            return;
    }
}

}  // namespace lanthorn::edit_window
