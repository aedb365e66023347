#include "lanthorn/workbench/motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "gi_module/reference/camera_rays.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/trace_scene.h"
#include "lanthorn/core/error.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/moved_nodes.h"
#include "tools/workbench/scene/placed_box.h"

namespace lanthorn::workbench {

namespace {

constexpr float kClear = 0.8f;         // of the way to what is in the way
constexpr int kLeastSwing = 3;         // frames: the last ones go one way
constexpr float kLampRadius = 0.05f;   // metres that a punctual light keeps clear
constexpr float kCameraRadius = 0.1f;  // and a camera
constexpr float kBoxShare = 0.12f;     // of the diagonal: the box's largest side
constexpr float kBoxMargin = 0.02f;    // between the box and what is round it

// A thing that wants room to move: a ball, render space.
struct Ball {
    vec3 centre{0};
    float radius = 0;
};

class Room {
  public:
    explicit Room(const FrameScene& frame)
        : materials_(*frame.assets),
          scene_(frame, materials_),
          bounds_(frame.bounds),
          diagonal_(frame.diagonal()) {}

    // Metres from `from` to the first surface that way; the scene's diagonal if there is none.
    float first_surface(const vec3& from, const vec3& direction, float nearest = 0) const {
        reference::SurfaceHit hit;
        return scene_.intersect(from, direction, nearest, diagonal_, reference::Blended::met, hit)
                   ? hit.t
                   : diagonal_;
    }
    // Metres that a ball may move that way, by five rays beside each other; what lies inside it is its own.
    // One inside the scene's bounds stays there: rooms may lack a wall.
    float ahead_of(const Ball& ball, const vec3& direction) const {
        const vec3 up = std::abs(direction.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
        const vec3 right = glm::normalize(glm::cross(direction, up));
        const vec3 beside[] = {vec3(0), right, -right, glm::cross(right, direction),
                               -glm::cross(right, direction)};
        float room = to_bounds(ball.centre, direction) - ball.radius;
        for (const vec3& offset : beside) {
            const vec3 from = ball.centre + 0.9f * ball.radius * offset;
            room = std::min(room, first_surface(from, direction, ball.radius) - ball.radius);
        }
        return std::max(room, 0.0f);
    }
    // The way with the most room for all of `balls`, at most `longest` metres.
    Swing widest(std::span<const Ball> balls, std::span<const vec3> directions, double longest) const {
        Swing best;
        for (const vec3& direction : directions) {
            float room = diagonal_;
            for (const Ball& ball : balls) {
                room = std::min(room, ahead_of(ball, direction));
            }
            const double reach = std::min(static_cast<double>(kClear * room), longest);
            if (reach > best.reach) {
                best = {dvec3(direction), reach};
            }
        }
        return best;
    }

  private:
    // Metres to where a ray leaves the scene's bounds; the diagonal for one that starts outside.
    float to_bounds(const vec3& from, const vec3& direction) const {
        float farthest = diagonal_;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(from[axis] >= bounds_.lower[axis] && from[axis] <= bounds_.upper[axis])) {
                return diagonal_;
            }
            if (direction[axis] != 0) {
                const float wall = direction[axis] > 0 ? bounds_.upper[axis] : bounds_.lower[axis];
                farthest = std::min(farthest, (wall - from[axis]) / direction[axis]);
            }
        }
        return farthest;
    }

    reference::MaterialTable materials_;
    reference::TraceScene scene_;
    Aabb bounds_;
    float diagonal_;
};

constexpr vec3 kLevel[] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};

// Where `entity` stands, and what of it lies round its place.
std::optional<Ball> ball_of(const FrameScene& frame, ecs::Entity entity) {
    for (const LightInstance& light : frame.lights) {
        if (light.id == entity.index) {
            return Ball{light.position, kLampRadius};
        }
    }
    Aabb bounds;
    for (const Instance& instance : frame.instances) {
        if (instance.id == entity.index) {
            bounds.add(instance.bounds);
        }
    }
    if (bounds.empty()) {
        return std::nullopt;
    }
    return Ball{bounds.centre(),
                0.5f * glm::length(vec2(bounds.upper.x - bounds.lower.x, bounds.upper.z - bounds.lower.z))};
}

std::vector<ecs::Entity> lamps_of(ecs::World& world) {
    std::vector<ecs::Entity> lamps = punctual_lights(world);
    return lamps.empty() ? emissive_meshes(world) : lamps;
}

vec3 right_of(const CameraView& camera) {
    return glm::normalize(glm::transpose(mat3(camera.view))[0]);
}

}  // namespace

std::string name_of(Motion motion) {
    return std::string(kMotionNames[static_cast<std::size_t>(motion)]);
}

Motion motion_named(std::string_view name) {
    const auto found = std::ranges::find(kMotionNames, name);
    if (found == kMotionNames.end()) {
        throw InputError(
            fmt::format("found no motion '{}', expected one of {}", name, fmt::join(kMotionNames, ", ")));
    }
    return static_cast<Motion>(found - kMotionNames.begin());
}

dvec3 Swing::before_end(double travelled) const {
    if (reach <= 0) {
        return dvec3(0);
    }
    const double part = std::fmod(travelled, 2 * reach);
    return direction * (part <= reach ? part : 2 * reach - part);
}

MovingScene::~MovingScene() = default;

MovingScene::MovingScene(const SceneData& scene, const SceneChoice& choice, Motion motion, int frames)
    : motion_(motion), frames_(frames), time_(choice.time.value_or(0)) {
    shown_ = std::make_unique<ShownScene>(scene, choice);
    shown_->show_at(time_);
    camera_ = shown_->frame().camera;
    if (motion == Motion::figure) {
        lacking_ = scene.animations.empty() || choice.animation == "none" ? "it has no animation" : "";
        return;
    }
    shown_->hold();
    switch (motion) {
        case Motion::lamp:
        case Motion::cut:
            prepare_lamp();
            break;
        case Motion::dim:
            prepare_dim();
            break;
        case Motion::walk:
            prepare_walk();
            break;
        case Motion::box:
        case Motion::box_rest:
            prepare_box(scene, choice);
            break;
        default:
            break;
    }
}

void MovingScene::prepare_lamp() {
    const FrameScene& frame = shown_->frame();
    moved_ = std::make_unique<MovedNodes>(shown_->world());
    std::vector<Ball> balls;
    bool turning = false;
    for (const ecs::Entity lamp : lamps_of(shown_->world())) {
        const auto* light = shown_->world().try_get<LightComponent>(lamp);
        const bool turns = light != nullptr && light->light.type == LightType::directional;
        const auto ball = ball_of(frame, lamp);
        if (ball && moved_->add(lamp, turns)) {
            turning = turning || turns;
            if (!turns) {
                balls.push_back(*ball);
            }
        }
    }
    if (!balls.empty()) {
        swing_ = Room(frame).widest(balls, kLevel, kLampStep * std::max(frames_, kLeastSwing));
    }
    if (!turning && swing_.reach < kLeastSwing * kLampStep) {
        lacking_ = "no lamp has room to move";
    }
}

void MovingScene::prepare_dim() {
    dimmed_ = std::make_unique<DimmedLights>(shown_->world());
    for (const ecs::Entity lamp : lamps_of(shown_->world())) {
        dimmed_->add(lamp);
        if (!dimmed_->empty()) {
            return;
        }
    }
    lacking_ = "it has no lamp";
}

void MovingScene::prepare_walk() {
    const vec3 right = right_of(camera_);
    const Ball head[] = {{camera_.position, kCameraRadius}};
    const vec3 sideways[] = {right, -right};
    swing_ = Room(shown_->frame()).widest(head, sideways, kWalkStep * std::max(frames_, kLeastSwing));
    if (swing_.reach < kLeastSwing * kWalkStep) {
        lacking_ = "the camera has no room to walk";
    }
}

void MovingScene::prepare_box(const SceneData& scene, const SceneChoice& choice) {
    const FrameScene& frame = shown_->frame();
    const Room room(frame);
    const reference::CameraRay middle = reference::CameraRays(camera_, ivec2(2)).ray(1, 1);
    const float depth = room.first_surface(middle.origin, middle.direction, middle.nearest);
    const vec3 right = right_of(camera_);
    const vec3 sideways[] = {right, -right};
    const float side = std::min(kBoxSide, kBoxShare * frame.diagonal());
    const float round = 0.5f * side * std::sqrt(3.0f);
    vec3 best(0);
    for (const float share : {0.5f, 0.6f, 0.4f, 0.7f, 0.3f}) {
        const vec3 centre = middle.origin + share * depth * middle.direction;
        bool free = glm::all(glm::greaterThan(centre - round, frame.bounds.lower)) &&
                    glm::all(glm::lessThan(centre + round, frame.bounds.upper));
        for (int k = 0; k < 27; ++k) {
            const vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
            free = free &&
                   (way == vec3(0) || room.first_surface(centre, glm::normalize(way)) > round + kBoxMargin);
        }
        const Ball ball[] = {{centre, round}};
        const Swing swing = room.widest(ball, sideways, kBoxStep * std::max(frames_, kLeastSwing));
        if (free && swing.reach > swing_.reach) {
            swing_ = swing;
            best = centre;
        }
    }
    if (swing_.reach < kLeastSwing * kBoxStep) {
        lacking_ = "there is no room for a box in the middle of the picture";
        return;
    }
    box_.add(best - 0.5f * side);
    box_.add(best + 0.5f * side);
    const dvec3 origin = frame.origin;
    placed_ = PlacedBox{origin + dvec3(best), side};

    SceneData with_box = scene;
    place_box(with_box, *placed_);
    shown_ = std::make_unique<ShownScene>(std::move(with_box), choice);  // `frame` is gone
    shown_->show_at(time_);
    shown_->hold();
    moved_ = std::make_unique<MovedNodes>(shown_->world());
    for (const ecs::Entity e : shown_->world().query<ecs::With<Name>>().entities()) {
        if (shown_->world().get<Name>(e).value == kBoxName) {
            moved_->add(e, false);
        }
    }
    // Render space may lie elsewhere with the box.
    const vec3 shift(origin - shown_->frame().origin);
    box_.lower += shift;
    box_.upper += shift;
    camera_ = shown_->frame().camera;
}

// The camera, `left` frames before the end.
void MovingScene::look(int left) {
    CameraView view = camera_;
    if (motion_ == Motion::walk && left > 0) {
        const vec3 aside(swing_.before_end(kWalkStep * left));
        view.position += aside;
        view.view = view.view * glm::translate(mat4(1), -aside);
    } else if (motion_ == Motion::pan && left > 0) {
        view.view = glm::rotate(mat4(1), static_cast<float>(kPanStep * left), vec3(0, 1, 0)) * view.view;
    } else if (motion_ == Motion::cut && left > 0) {
        view.view = glm::rotate(mat4(1), kPi, vec3(0, 1, 0)) * view.view;
    }
    shown_->app().view().placed = view;
}

const FrameScene& MovingScene::show(int frame) {
    const int left = frames_ - frame;
    if (motion_ == Motion::figure) {
        shown_->show_at(time_ + kFigureStep * frame);
        return shown_->frame();
    }
    if (moved_) {
        const double step = motion_ == Motion::box ? kBoxStep : motion_ == Motion::box_rest ? 0 : kLampStep;
        moved_->move(swing_.before_end(step * left), kLampTurn * left);
    }
    if (dimmed_) {
        dimmed_->dim(static_cast<float>(std::pow(1 - kDimStep, -left)));
    }
    look(left);
    shown_->app().show();
    return shown_->frame();
}

}  // namespace lanthorn::workbench
