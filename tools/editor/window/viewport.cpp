// What a person does in the viewport; viewport_draw.cpp has what is drawn there.
#include "tools/editor/window/viewport.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/scene/components.h"
#include "lanthorn/shell/cameras.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/window/lines.h"

namespace lanthorn::edit_window {

using editor::EditModel;
using editor::EditSession;
using workbench::CameraPose;

namespace {

constexpr float kClick = 4;      // units that the hand may shake within a click
constexpr double kTurn = 0.005;  // radians a pixel
constexpr double kIcon = 12;     // units: half of a light icon's target

shell::Gaze gaze_of(const CameraPose& pose) {
    return {glm::radians(pose.yaw), glm::radians(pose.pitch)};
}

CameraPose with(CameraPose pose, const dvec3& at, const shell::Gaze& gaze) {
    pose.at = at;
    pose.yaw = glm::degrees(gaze.yaw);
    pose.pitch = glm::degrees(gaze.pitch);
    return pose;
}

// The node and all above it that are chosen: who moves with whom.
bool moves_with_another(const EditModel& model, std::uint32_t node,
                        const std::vector<std::uint32_t>& chosen) {
    return std::ranges::any_of(
        chosen, [&](std::uint32_t other) { return other != node && model.is_within(node, other); });
}

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

void Viewport::set_pose(const CameraPose& pose, double now) {
    if (pose == pose_) {
        return;
    }
    pose_ = pose;
    state_.desk.act([pose](EditSession& session) { session.set_pose(pose); });
    state_.pace.changed(now, true);
}

void Viewport::look_from_session() {
    pose_ = state_.session.pose();
    // Round what is in the middle of the picture, about as far as lamps stand.
    distance_ = 3;
    double nearest = 1e9;
    for (const editor::LightRow& light : editor::lights_table(state_.session.model())) {
        const double away = glm::dot(light.at - pose_.at, gaze_of(pose_).ahead());
        nearest = light.node != kNone && away > 0.5 ? std::min(nearest, away) : nearest;
    }
    distance_ = nearest < 1e9 ? nearest : distance_;
    state_.pace.changed(0, false);
}

void Viewport::picture_drawn() {
    const FrameScene& scene = state_.session.world().resource<FrameScene>();
    look_ = scene.camera;
    origin_ = scene.origin;
}

void Viewport::read_light() {
    if (lux_of_frame_ != state_.picture.frames()) {
        lux_ = lux_of(state_.session.app());
        lux_of_frame_ = state_.picture.frames();
    }
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

void Viewport::frame(const std::vector<std::uint32_t>& nodes, double now) {
    const FrameScene& scene = state_.session.world().resource<FrameScene>();
    Aabb bounds;
    if (nodes.empty()) {
        bounds = scene.bounds;
    } else {
        for (const std::uint32_t node : nodes) {
            if (state_.session.model().find(node) == nullptr) {
                continue;
            }
            const vec3 at(dvec3(state_.session.model().world_matrix(node)[3]) - scene.origin);
            const Aabb drawn = bounds_of(node);
            bounds.add(drawn);
            if (drawn.empty()) {  // a light, a camera: what is around it
                bounds.add(at + vec3(0.2f));
                bounds.add(at - vec3(0.2f));
            }
        }
    }
    shell::OrbitCamera orbit;
    orbit.gaze = gaze_of(pose_);
    orbit.show_all(bounds, scene.origin, glm::radians(pose_.fov),
                   static_cast<double>(eye_.box().width) / std::max(1.0f, eye_.box().height));
    distance_ = orbit.distance;
    set_pose(with(pose_, dvec3(orbit.world()[3]), orbit.gaze), now);
}

// --- handles ---

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
        // Shapes whose origin lies elsewhere are taken at their middle.
        const dvec3 origin = state_.session.world().resource<FrameScene>().origin;
        const Aabb bounds = bounds_of(last);
        const vec3 pivot(place.pivot - origin);
        const vec3 slack = 0.1f * bounds.size();
        if (!bounds.empty() && (glm::any(glm::lessThan(pivot, bounds.lower - slack)) ||
                                glm::any(glm::greaterThan(pivot, bounds.upper + slack)))) {
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
        if (found == nullptr || moves_with_another(model, node, state_.chosen)) {
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
    keep ? state_.desk.commit() : state_.desk.cancel();
    state_.pace.hold(false, now);
    state_.pace.changed(now, true);
    typed_.clear();
    change_words_.clear();
}

void Viewport::cancel() {
    finish_drag(false, glfwGetTime());
    navigating_ = Navigating::none;
    state_.pace.hold(false, glfwGetTime());
    marquee_from_.reset();
    pressed_ = false;
}

// --- mouse ---

std::vector<std::uint32_t> Viewport::under(const vec2& pixel) {
    std::vector<std::uint32_t> found;
    const auto add = [&](std::uint32_t node) {
        if (node != kNone && std::ranges::find(found, node) == found.end()) {
            found.push_back(node);
        }
    };
    // Icons first: they are small and lie over everything.
    if (state_.helpers) {
        for (const editor::LightRow& light : state_.lights) {
            const auto at = eye_.at(light.at);
            const double reach = kIcon * static_cast<double>(state_.unit);
            if (at && light.shown && static_cast<double>(glm::length(*at - pixel)) < reach) {
                add(light.node);
            }
        }
    }
    EditSession& session = state_.session;
    if (session.world().try_resource<FrameScene>() != nullptr) {
        PickOptions options;
        options.lights = options.cameras = false;
        for (const Picked& hit :
             pick(session.world(), session.world().resource<FrameScene>(), eye_.ray(pixel), options)) {
            add(session.node_of(hit.entity));
        }
    }
    return found;
}

void Viewport::click(const vec2& pixel, bool add) {
    std::vector<std::uint32_t> found = under(pixel);
    const bool again = glm::length(pixel - clicked_at_) < kClick * state_.unit && found == last_under_;
    clicked_at_ = pixel;
    if (found.empty()) {
        if (!add) {
            state_.select({});
        }
        last_under_.clear();
        return;
    }
    // Clicking again takes what lies behind.
    cycle_ = again && !add ? (cycle_ + 1) % found.size() : 0;
    const std::uint32_t node = found[cycle_];
    last_under_ = std::move(found);
    std::vector<std::uint32_t> chosen = add ? state_.chosen : std::vector<std::uint32_t>();
    const auto at = std::ranges::find(chosen, node);
    if (at != chosen.end()) {
        chosen.erase(at);
    } else {
        chosen.push_back(node);
    }
    state_.reveal = node;
    state_.select(std::move(chosen));
}

void Viewport::marquee(bool add) {
    const vec2 a = glm::min(*marquee_from_, last_), b = glm::max(*marquee_from_, last_);
    std::vector<std::uint32_t> chosen = add ? state_.chosen : std::vector<std::uint32_t>();
    const auto take = [&](std::uint32_t node) {
        if (node != kNone && std::ranges::find(chosen, node) == chosen.end()) {
            chosen.push_back(node);
        }
    };
    // Only what is seen: a grid of rays, and lights by their icons.
    constexpr int kRays = 24;
    for (int y = 0; y < kRays; ++y) {
        for (int x = 0; x < kRays; ++x) {
            const vec2 pixel = a + (b - a) * (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) /
                                       static_cast<float>(kRays);
            PickOptions options;
            options.lights = options.cameras = false;
            const auto hits = pick(state_.session.world(), state_.session.world().resource<FrameScene>(),
                                   eye_.ray(pixel), options);
            if (!hits.empty()) {
                take(state_.session.node_of(hits.front().entity));
            }
        }
    }
    for (const editor::LightRow& light : state_.lights) {
        const auto at = eye_.at(light.at);
        if (at && light.shown && at->x >= a.x && at->y >= a.y && at->x <= b.x && at->y <= b.y) {
            take(light.node);
        }
    }
    state_.select(std::move(chosen));
}

void Viewport::press(const Happening& h) {
    last_ = pressed_at_ = h.at;
    moved_ = false;
    const bool alt = (h.modifiers & GLFW_MOD_ALT) != 0, shift = (h.modifiers & GLFW_MOD_SHIFT) != 0;
    if (h.code == GLFW_MOUSE_BUTTON_MIDDLE || (h.code == GLFW_MOUSE_BUTTON_LEFT && alt)) {
        navigating_ = shift ? Navigating::pan : Navigating::orbit;
        state_.pace.hold(true, h.time);
        return;
    }
    if (h.code == GLFW_MOUSE_BUTTON_RIGHT) {
        if (handles_.held()) {
            finish_drag(false, h.time);
            return;
        }
        navigating_ = Navigating::fly;
        state_.pace.hold(true, h.time);
        return;
    }
    if (h.code != GLFW_MOUSE_BUTTON_LEFT) {
        return;
    }
    pressed_ = true;
    press_adds_ = (h.modifiers & GLFW_MOD_CONTROL) != 0;
    const Part part = state_.tool == Tool::select ? Part::none : handles_.hit(h.at);
    if (part != Part::none) {
        begin_drag(part, h.at);
        state_.pace.hold(true, h.time);
    }
}

void Viewport::move(const Happening& h) {
    const vec2 way = h.at - last_;
    last_ = h.at;
    if (glm::length(h.at - pressed_at_) > kClick * state_.unit) {
        moved_ = true;
    }
    if (navigating_ != Navigating::none) {
        shell::OrbitCamera orbit;
        orbit.gaze = gaze_of(pose_);
        orbit.distance = distance_;
        orbit.target = pose_.at + distance_ * orbit.gaze.ahead();
        if (navigating_ == Navigating::pan) {
            const double height = std::max(1.0f, eye_.box().height);
            orbit.pan(-static_cast<double>(way.x) / height, static_cast<double>(way.y) / height,
                      glm::radians(pose_.fov));
            set_pose(with(pose_, dvec3(orbit.world()[3]), orbit.gaze), h.time);
            return;
        }
        orbit.gaze.turn(-kTurn * static_cast<double>(way.x), -kTurn * static_cast<double>(way.y));
        // Who flies turns the head, who orbits goes round.
        set_pose(navigating_ == Navigating::fly ? with(pose_, pose_.at, orbit.gaze)
                                                : with(pose_, dvec3(orbit.world()[3]), orbit.gaze),
                 h.time);
        return;
    }
    if (handles_.held()) {
        drag_pixel_ = h.at;
        drag_modifiers_ = h.modifiers;
        if (moved_) {
            drag_on(h.time);
        }
        return;
    }
    if (pressed_ && moved_) {
        marquee_from_ = pressed_at_;
        return;
    }
    hovered_ = state_.tool == Tool::select ? Part::none : handles_.hit(h.at);
}

void Viewport::release(const Happening& h) {
    if (navigating_ != Navigating::none) {
        navigating_ = Navigating::none;
        state_.pace.hold(false, h.time);
        return;
    }
    if (h.code != GLFW_MOUSE_BUTTON_LEFT || !pressed_) {
        return;
    }
    pressed_ = false;
    if (handles_.held()) {
        if (moved_ || !typed_.empty()) {
            finish_drag(true, h.time);
            return;
        }
        handles_.end();  // a click on a handle is one on what lies below
        state_.pace.hold(false, h.time);
    }
    if (marquee_from_) {
        marquee(press_adds_);
        marquee_from_.reset();
        return;
    }
    click(h.at, press_adds_);
}

bool Viewport::take(const Happening& h, bool over) {
    using Kind = Happening::Kind;
    const bool busy = gesture() || pressed_;
    switch (h.kind) {
        case Kind::press:
            if (!over && !busy) {
                return false;
            }
            press(h);
            return true;
        case Kind::release:
            release(h);
            return busy;
        case Kind::move:
            if (!over && !busy) {
                last_ = h.at;
                hovered_ = Part::none;
                return false;
            }
            move(h);
            return true;
        case Kind::wheel: {
            if (!over) {
                return false;
            }
            if (navigating_ == Navigating::fly) {
                fly_speed_ =
                    std::clamp(fly_speed_ * std::pow(1.2, static_cast<double>(h.notches)), 0.05, 500.0);
                return true;
            }
            // To the point under the pointer.
            const PickRay ray = eye_.ray(h.at);
            const double nearer = std::pow(0.9, static_cast<double>(h.notches));
            const double step = distance_ * (1 - nearer);
            distance_ = std::clamp(distance_ * nearer, 0.05, 1e6);
            set_pose(with(pose_, pose_.at + step * ray.direction, gaze_of(pose_)), h.time);
            return true;
        }
        case Kind::key:
            if (!handles_.held()) {
                return false;
            }
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
        case Kind::drop:
            return false;
    }
    return false;
}

bool Viewport::act(Act act, double now) {
    switch (act) {
        case Act::tool_select:
            state_.tool = Tool::select;
            return true;
        case Act::tool_move:
            state_.tool = Tool::move;
            return true;
        case Act::tool_rotate:
            state_.tool = Tool::rotate;
            return true;
        case Act::tool_scale:
            state_.tool = Tool::scale;
            return true;
        case Act::axis_y:
        case Act::latch_snap:
            state_.snap_latched = !state_.snap_latched;
            return true;
        case Act::local_axes:
            state_.local_axes = !state_.local_axes;
            return true;
        case Act::frame_selection:
            frame(state_.chosen, now);
            return true;
        case Act::frame_all:
            frame({}, now);
            return true;
        case Act::look_through_game_camera:
            set_pose(state_.session.file_pose(), now);
            return true;
        case Act::drop_to_floor: {
            std::vector<std::string> lines;
            const EditModel& model = state_.session.model();
            for (const std::uint32_t node : state_.chosen) {
                const editor::ModelNode* found = model.find(node);
                if (found == nullptr || moves_with_another(model, node, state_.chosen)) {
                    continue;
                }
                const dvec3 at(model.world_matrix(node)[3]);
                PickOptions options;
                options.lights = options.cameras = false;
                for (const Picked& hit :
                     pick(state_.session.world(), state_.session.world().resource<FrameScene>(),
                          {at, dvec3(0, -1, 0)}, options)) {
                    const std::uint32_t below = state_.session.node_of(hit.entity);
                    if (below == kNone || model.is_within(below, node)) {
                        continue;
                    }
                    const dmat4 parent =
                        found->parent == kNone ? dmat4(1) : model.world_matrix(found->parent);
                    lines.push_back(move_line(state_.session.path_of(node),
                                              dvec3(glm::inverse(parent) * dvec4(hit.position, 1))));
                    break;
                }
            }
            if (!lines.empty()) {
                state_.desk.run("drop to the surface below", std::move(lines));
                state_.pace.changed(now, false);
            }
            return true;
        }
        default:
            return false;
    }
}

bool Viewport::move_on(double now, double seconds, const InputQueue& input) {
    if (navigating_ != Navigating::fly) {
        return false;
    }
    const auto down = [&](int key) { return input.is_down(key) ? 1.0 : 0.0; };
    const dvec3 way(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_E) - down(GLFW_KEY_Q),
                    down(GLFW_KEY_W) - down(GLFW_KEY_S));
    if (way == dvec3(0)) {
        return false;
    }
    shell::FlyCamera fly{pose_.at, gaze_of(pose_), fly_speed_};
    const int modifiers = input.modifiers();
    fly.speed *= (modifiers & GLFW_MOD_SHIFT) != 0 ? 4 : (modifiers & GLFW_MOD_ALT) != 0 ? 0.25 : 1;
    fly.move(way, std::min(seconds, 0.25));
    set_pose(with(pose_, fly.place, fly.gaze), now);
    return true;
}

}  // namespace lanthorn::edit_window
