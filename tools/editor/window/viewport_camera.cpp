// Where the viewport looks from: orbit, pan, fly, nearer and farther, and whole things in the picture.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/scene/components.h"
#include "lanthorn/shell/cameras.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

using editor::EditSession;
using workbench::CameraPose;

namespace {

constexpr double kTurnRate = 0.005;  // radians a pixel

shell::Gaze gaze_of(const CameraPose& pose) {
    return {glm::radians(pose.yaw), glm::radians(pose.pitch)};
}

CameraPose with(CameraPose pose, const dvec3& at, const shell::Gaze& gaze) {
    pose.at = at;
    pose.yaw = glm::degrees(gaze.yaw);
    pose.pitch = glm::degrees(gaze.pitch);
    return pose;
}

}  // namespace

void Viewport::set_pose(const CameraPose& pose, double now, bool jump) {
    if (!(pose == pose_)) {
        history_.leave(looked(), now, jump);
        put_pose(pose, now);
    }
}

void Viewport::put_pose(const CameraPose& pose, double now) {
    pose_ = pose;
    state_.desk.act([pose](EditSession& session) { session.set_pose(pose); });
    state_.pace.changed(now, true);
}

void Viewport::look_from_session() {
    pose_ = state_.session.pose();
    history_.clear();
    find_distance();
    state_.pace.changed(0, false);
}

void Viewport::find_distance() {
    // Round what is in the middle of the picture, about as far as lamps stand.
    distance_ = 3;
    double nearest = 1e9;
    for (const editor::LightRow& light : editor::lights_table(state_.session.model())) {
        const double away = glm::dot(light.at - pose_.at, gaze_of(pose_).ahead());
        nearest = light.node != kNone && away > 0.5 ? std::min(nearest, away) : nearest;
    }
    distance_ = nearest < 1e9 ? nearest : distance_;
}

// A hand moves the camera by so many pixels.
void Viewport::look_round(const vec2& way, double now) {
    shell::OrbitCamera orbit;
    orbit.gaze = gaze_of(pose_);
    orbit.distance = distance_;
    orbit.target = pose_.at + distance_ * orbit.gaze.ahead();
    if (navigating_ == Navigating::pan) {
        const double height = std::max(1.0f, eye_.box().height);
        orbit.pan(-static_cast<double>(way.x) / height, static_cast<double>(way.y) / height,
                  glm::radians(pose_.fov));
        set_pose(with(pose_, dvec3(orbit.world()[3]), orbit.gaze), now);
        return;
    }
    orbit.gaze.turn(-kTurnRate * static_cast<double>(way.x), -kTurnRate * static_cast<double>(way.y));
    // Who flies turns the head, who orbits goes round.
    set_pose(navigating_ == Navigating::fly ? with(pose_, pose_.at, orbit.gaze)
                                            : with(pose_, dvec3(orbit.world()[3]), orbit.gaze),
             now);
}

void Viewport::approach(const Happening& h) {
    if (navigating_ == Navigating::fly) {
        fly_speed_ = std::clamp(fly_speed_ * std::pow(1.2, static_cast<double>(h.notches)), 0.05, 500.0);
        return;
    }
    // To the point under the pointer.
    const PickRay ray = eye_.ray(h.at);
    const double nearer = std::pow(0.9, static_cast<double>(h.notches));
    const double step = distance_ * (1 - nearer);
    distance_ = std::clamp(distance_ * nearer, 0.05, 1e6);
    set_pose(with(pose_, pose_.at + step * ray.direction, gaze_of(pose_)), h.time);
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
    set_pose(with(pose_, dvec3(orbit.world()[3]), orbit.gaze), now, true);
}

bool Viewport::act_on_camera(Act act, double now) {
    const auto go = [&](const std::optional<LookedAt>& view, const char* none) {
        if (!view) {
            state_.say(none, now);
            return;
        }
        state_.other_side = view->beside;
        ++state_.other_pictures;
        put_pose(view->pose, now);
        find_distance();
    };
    if (act == Act::frame_selection || act == Act::frame_all) {
        frame(act == Act::frame_all ? std::vector<std::uint32_t>() : state_.chosen, now);
    } else if (act == Act::look_through_game_camera) {
        set_pose(state_.session.file_pose(), now, true);
    } else if (act == Act::view_before) {
        go(history_.back(looked(), now), "no view before this one");
    } else if (act == Act::view_after) {
        go(history_.forth(looked(), now), "no view after this one");
    } else if (const int keeps = view_number(act, Act::keep_view); keeps > 0) {
        if (state_.session.is_open()) {
            state_.views.keep(state_.views_file(), keeps, pose_);
            state_.views_changed = true;
            state_.say("kept as view " + std::to_string(keeps), now);
        }
    } else if (const int goes = view_number(act, Act::go_to_view); goes > 0) {
        const CameraPose* kept = state_.views.find(state_.views_file(), goes);
        if (kept == nullptr) {
            const std::string number = std::to_string(goes);
            state_.say("no view " + number + " yet: Ctrl+" + number + " keeps one", now);
        } else if (state_.session.is_open()) {
            set_pose(*kept, now, true);
            find_distance();
        }
    } else {
        return false;
    }
    return true;
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
