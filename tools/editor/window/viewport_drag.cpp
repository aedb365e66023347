// Handles: where they stand, and what dragging them does to what is chosen.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lanthorn/scene/components.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/pivot.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

using editor::EditModel;
using editor::EditSession;

namespace {

Transform relative_to(const dmat4& parent, const dmat4& world, Transform was) {
    const dmat4 local = glm::inverse(parent) * world;
    was.translation = dvec3(local[3]);
    glm::dmat3 axes(local);
    for (int i = 0; i < 3; ++i) {
        axes[i] = glm::length(axes[i]) > 0 ? glm::normalize(axes[i]) : axes[i];
    }
    if (glm::determinant(axes) < 0) {
        axes[0] = -axes[0];
    }
    was.rotation = quat(glm::normalize(glm::quat_cast(axes)));
    return was;
}

}  // namespace

bool Viewport::moves_with_another(std::uint32_t node) const {
    return std::ranges::any_of(state_.chosen, [&](std::uint32_t other) {
        return other != node && state_.session.model().is_within(node, other);
    });
}

Aabb Viewport::bounds_of(std::uint32_t node) const {
    Aabb bounds;
    editor::EditSession& session = state_.session;
    const FrameScene* scene = session.world().try_resource<FrameScene>();
    const EditModel& model = session.model();
    if (scene == nullptr || model.find(node) == nullptr) {
        return bounds;
    }
    const std::vector<ecs::Entity> entities = session.entities();
    for (std::uint32_t n = 0; n < entities.size(); ++n) {
        if (!entities[n] || model.find(n) == nullptr || model.node(n).mesh == kNone ||
            !model.is_within(n, node)) {
            continue;
        }
        for (const Instance& instance : scene->instances) {
            if (instance.id == entities[n].index) {
                bounds.add(instance.bounds);
            }
        }
    }
    return bounds;
}

void Viewport::place_handles() {
    const EditModel& model = state_.session.model();
    HandlePlace place;
    int count = 0;
    for (const std::uint32_t node : state_.chosen) {
        if (model.find(node) != nullptr) {
            place.pivot += dvec3(model.world_matrix(node)[3]);
            ++count;
        }
    }
    if (count == 0 || !state_.helpers) {
        handles_.clear();
        return;
    }
    place.pivot /= count;
    const std::uint32_t last = state_.chosen.back();
    if (count == 1 && !handles_.held()) {
        // Shapes that were made where they stand, with the origin anywhere, are taken at their middle.
        const dvec3 origin = state_.session.world().resource<FrameScene>().origin;
        const Aabb bounds = bounds_of(last);
        const vec3 pivot(place.pivot - origin);
        if (!origin_is_meant(bounds, pivot)) {
            place.pivot = origin + dvec3(bounds.centre());
        }
    }
    if (handles_.held()) {
        place.pivot = handles_.taken().pivot + dragged_;
    }
    glm::dmat3 own(1);
    if (model.find(last) != nullptr) {
        own = glm::dmat3(model.world_matrix(last));
        for (int i = 0; i < 3; ++i) {
            own[i] = glm::length(own[i]) > 1e-12 ? glm::normalize(own[i]) : glm::dmat3(1)[i];
        }
    }
    // A scale is along the node's own axes, always.
    place.axes = state_.local_axes || state_.tool == Tool::scale ? own : glm::dmat3(1);
    if (count == 1) {
        if (const Light* light = editor::light_of(model, last)) {
            place.light_axes = own;
            if (light->type != LightType::directional && std::isfinite(light->range)) {
                place.range = static_cast<double>(light->range);
            }
            if (light->type == LightType::spot) {
                place.cone = static_cast<double>(light->outer_cone);
            }
        }
    }
    handles_.place(place, state_.tool, eye_, state_.unit);
}

void Viewport::begin_drag(Part part, const vec2& pixel) {
    const EditModel& model = state_.session.model();
    marked_.clear();
    for (const std::uint32_t node : state_.chosen) {
        const editor::ModelNode* found = model.find(node);
        if (found == nullptr || moves_with_another(node)) {
            continue;
        }
        marked_.push_back(
            {node, found->local, found->parent == kNone ? dmat4(1) : model.world_matrix(found->parent)});
    }
    typed_.clear();
    change_words_.clear();
    drag_pixel_ = pixel;
    dragged_ = dvec3(0);
    handles_.begin(part, pixel);
}

void Viewport::begin_at_once(Tool tool, double now) {
    if (gesture() || pressed_ || state_.chosen.empty() || !state_.layout.picture.contains(last_)) {
        return;
    }
    state_.tool = tool;
    place_handles();
    begin_drag(Part::view, last_);
    if (marked_.empty()) {
        handles_.end();
        return;
    }
    at_once_ = true;
    state_.pace.hold(true, now);
}

void Viewport::drag_on(double now) {
    const EditSession& session = state_.session;
    const bool snap = state_.snap_latched != ((drag_modifiers_ & GLFW_MOD_CONTROL) != 0);
    std::optional<double> typed;
    if (!typed_.empty() && typed_ != "-") {
        typed = std::atof(typed_.c_str());
    }
    const HandleChange change = handles_.change(drag_pixel_, snap, state_.steps, typed);
    change_words_ = change.words + (typed_.empty() ? "" : "   typed " + typed_);
    std::vector<std::string> lines;
    std::string what = state_.tool == Tool::rotate ? "turn" : state_.tool == Tool::scale ? "scale" : "move";
    const Part part = handles_.part();
    const dvec3 pivot = handles_.taken().pivot;
    dragged_ = change.move;
    for (const Marked& each : marked_) {
        const std::string path = session.path_of(each.node);
        if (part == Part::range || part == Part::cone) {
            what = part == Part::range ? "range of" : "cone of";
            if (part == Part::range) {
                lines.push_back(set_line(path, "light.range", json_number(change.range)));
            } else {
                lines.push_back(set_line(path, "light.outer_cone", json_number(change.cone)));
            }
            continue;
        }
        const dmat4 world = each.parent * each.local.matrix();
        dmat4 moved = world;
        if (state_.tool == Tool::rotate) {
            const dmat4 turn = glm::mat4_cast(change.turn);
            moved = turn * world;
            moved[3] = dvec4(pivot + dvec3(turn * dvec4(dvec3(world[3]) - pivot, 0)), 1);
        }
        moved[3] += dvec4(change.move, 0);
        Transform to = each.local;
        if (state_.tool == Tool::scale) {
            to.scale = vec3(dvec3(each.local.scale) * change.stretch);
            // Away from the pivot along the axes that are stretched.
            const glm::dmat3& axes = handles_.taken().axes;
            const dvec3 way = change.stretch * (glm::transpose(axes) * (dvec3(world[3]) - pivot));
            to.translation = dvec3(glm::inverse(each.parent) * dvec4(pivot + axes * way, 1));
        } else if (state_.tool == Tool::rotate) {
            to = relative_to(each.parent, moved, each.local);
        } else {
            to.translation = dvec3(glm::inverse(each.parent) * moved[3]);
            // Hands are not exact: no more digits than a tenth of a millimetre, or of a pixel where that is
            // less.
            const double fine =
                std::min(1e-4, std::pow(10, std::floor(std::log10(0.1 / eye_.pixels_a_metre(pivot)))));
            to.translation = glm::round(to.translation / fine) * fine;
            to.translation = glm::round(to.translation * 1e6) / 1e6;
        }
        for (std::string& line : transform_lines(path, each.local, to)) {
            lines.push_back(std::move(line));
        }
    }
    if (marked_.empty()) {
        return;
    }
    const std::string whom = marked_.size() == 1 ? editor::called(session.model(), marked_.front().node)
                                                 : std::to_string(marked_.size()) + " things";
    state_.desk.preview(what + " " + whom, std::move(lines));
    state_.pace.changed(now, true);
}

void Viewport::finish_drag(bool keep, double now) {
    if (!handles_.held()) {
        return;
    }
    handles_.end();
    at_once_ = false;
    keep ? state_.desk.commit() : state_.desk.cancel();
    state_.pace.hold(false, now);
    state_.pace.changed(now, true);
    typed_.clear();
    change_words_.clear();
}

// While a handle is held.
bool Viewport::take_drag_key(const Happening& h) {
    if (h.code == GLFW_KEY_ESCAPE) {
        cancel();
        return true;
    }
    if (h.code == GLFW_KEY_ENTER || h.code == GLFW_KEY_KP_ENTER) {
        finish_drag(true, h.time);
        return true;
    }
    if (h.code == GLFW_KEY_BACKSPACE && !typed_.empty()) {
        typed_.pop_back();
    } else if (h.code >= GLFW_KEY_0 && h.code <= GLFW_KEY_9) {
        typed_ += static_cast<char>('0' + h.code - GLFW_KEY_0);
    } else if (h.code >= GLFW_KEY_KP_0 && h.code <= GLFW_KEY_KP_9) {
        typed_ += static_cast<char>('0' + h.code - GLFW_KEY_KP_0);
    } else if ((h.code == GLFW_KEY_PERIOD || h.code == GLFW_KEY_KP_DECIMAL) &&
               typed_.find('.') == std::string::npos) {
        typed_ += '.';
    } else if ((h.code == GLFW_KEY_MINUS || h.code == GLFW_KEY_KP_SUBTRACT) && typed_.empty()) {
        typed_ = "-";
    } else if (h.code == GLFW_KEY_X || h.code == GLFW_KEY_Y || h.code == GLFW_KEY_Z) {
        const bool plane = (h.modifiers & GLFW_MOD_SHIFT) != 0;
        const int i = h.code - GLFW_KEY_X;
        constexpr Part kAxes[] = {Part::x, Part::y, Part::z};
        constexpr Part kPlanes[] = {Part::yz, Part::zx, Part::xy};
        handles_.constrain(plane ? kPlanes[i] : kAxes[i]);
    } else {
        return false;
    }
    drag_on(h.time);
    return true;
}

}  // namespace lanthorn::edit_window
