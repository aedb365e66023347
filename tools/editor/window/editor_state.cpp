#include "tools/editor/window/editor_state.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/gtx/quaternion.hpp>
#include <utility>

#include "lanthorn/gi/technique.h"
#include "tools/editor/window/lines.h"

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

const KeptPicture* EditorState::kept_picture() const {
    return other_side && other_side->kept ? &*other_side->kept : nullptr;
}

void EditorState::compare_as(editor::DrawnAs as) {
    compare_with = as.technique();
    OtherSide side;
    side.as = std::move(as);
    compare(std::make_shared<const OtherSide>(std::move(side)));
}

bool EditorState::draws_reference() const {
    const gi::TechniqueEntry* entry = gi::find_technique(settings.text("gi.technique"));
    return entry != nullptr && entry->is_reference;
}

void EditorState::set_technique(const std::string& name) {
    if (!draws_reference()) {
        technique_before = settings.text("gi.technique");
    }
    settings.set_from_text("gi.technique", name);
    settings_changed = true;
}

void EditorState::leave_reference() {
    if (draws_reference()) {
        set_technique(technique_before.empty() ? gi::technique_names().front() : technique_before);
    }
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
    timeline.clips = editor::clip_rows(session);
    timeline.starts_with = editor::start_clip(session, timeline.clips);
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

void EditorState::add_light(const std::string& name, std::string_view type, const dvec3& at,
                            const vec3& shines) {
    problem.clear();
    desk.act([this, name, type = std::string(type), at, shines](editor::EditSession& edited) {
        const bool was_lent = !edited.guests().empty();
        std::vector<std::string> lines = {
            fmt::format("add-light / {} {} {:.4f} {:.4f} {:.4f}", name, type, at.x, at.y, at.z)};
        edited.begin(fmt::format("add {}", name));
        try {
            edited.preview(lines);
            if (type != "point") {
                const std::uint32_t made = edited.model().roots.back();
                lines.push_back(turn_line(edited.path_of(made), glm::rotation(vec3(0, 0, -1), shines)));
                edited.preview(lines);
            }
            edited.commit();
        } catch (...) {
            edited.cancel();
            throw;
        }
        edited.select({edited.model().roots.back()});
        reveal = edited.selection().back();
        if (was_lent && edited.guests().empty()) {
            toast = "the file has a light of its own now: the lent one is off, as in the game";
            toast_until = 1e18;
        }
    });
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
