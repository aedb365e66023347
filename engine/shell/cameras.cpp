#include "lanthorn/shell/cameras.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::shell {

namespace {

constexpr double kSteepest = 0.499 * std::numbers::pi;
constexpr double kNotch = 0.9;   // of the distance that is left
constexpr double kMargin = 1.1;  // round what is to be seen

double finite(double value) {
    return std::isfinite(value) ? value : 0;
}

}  // namespace

void Gaze::turn(double more_yaw, double more_pitch) {
    yaw = std::remainder(yaw + finite(more_yaw), 2 * std::numbers::pi);
    pitch = std::clamp(pitch + finite(more_pitch), -kSteepest, kSteepest);
}

dvec3 Gaze::ahead() const {
    return {-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

dvec3 Gaze::walk(double right, double ahead) const {
    const double sine = std::sin(yaw), cosine = std::cos(yaw);
    const dvec3 way = finite(right) * dvec3(cosine, 0, -sine) + finite(ahead) * dvec3(-sine, 0, -cosine);
    return way / std::max(1.0, glm::length(way));
}

dmat4 camera_at(const dvec3& place, const Gaze& gaze) {
    const glm::dquat turned =
        glm::angleAxis(gaze.yaw, dvec3(0, 1, 0)) * glm::angleAxis(gaze.pitch, dvec3(1, 0, 0));
    dmat4 world = glm::mat4_cast(turned);
    world[3] = dvec4(place, 1);
    return world;
}

Gaze gaze_of(const dmat4& world) {
    glm::dmat3 basis(1);
    if (!orthonormal_basis(world, basis)) {
        return {};
    }
    const dvec3 ahead = -basis[2];
    // Straight up or down the picture's upper edge tells the yaw.
    const bool steep = std::hypot(ahead.x, ahead.z) < 1e-6;
    const dvec3 level = !steep ? ahead : ahead.y < 0 ? basis[1] : -basis[1];
    return {std::atan2(-level.x, -level.z),
            std::clamp(std::asin(std::clamp(ahead.y, -1.0, 1.0)), -kSteepest, kSteepest)};
}

void FlyCamera::move(const dvec3& way, double seconds) {
    const dvec3 right(std::cos(gaze.yaw), 0, -std::sin(gaze.yaw));
    const dvec3 wish = finite(way.x) * right + finite(way.y) * dvec3(0, 1, 0) + finite(way.z) * gaze.ahead();
    place += wish * (finite(seconds) * speed / std::max(1.0, glm::length(wish)));
}

void OrbitCamera::zoom(double notches) {
    distance = std::clamp(distance * std::pow(kNotch, finite(notches)), kNearest, kFarthest);
}

void OrbitCamera::pan(double right, double up, double yfov) {
    const dmat4 at = world();
    const double height = 2 * distance * std::tan(0.5 * yfov);  // of the picture, metres at the target
    target += height * (finite(right) * dvec3(at[0]) + finite(up) * dvec3(at[1]));
}

void OrbitCamera::show_all(const Aabb& bounds, const dvec3& origin, double yfov, double aspect) {
    const dvec3 lower(bounds.lower), upper(bounds.upper);
    const bool usable = !bounds.empty() && std::isfinite(glm::length(upper - lower));
    const double radius = usable ? std::max(0.5 * glm::length(upper - lower), kNearest) : std::sqrt(3.0);
    target = origin + (usable ? 0.5 * (lower + upper) : dvec3(0));
    const double narrow = std::atan(std::tan(0.5 * yfov) * std::min(1.0, aspect));
    distance = std::clamp(kMargin * radius / std::sin(narrow), kNearest, kFarthest);
}

void FollowCamera::follow(const dvec3& target, double yaw, double seconds) {
    const bool jumps = !began_ || glm::distance(target, target_) > kJump * distance;
    const double left =
        jumps || half_life <= 0 ? 0 : std::exp2(-std::max(0.0, finite(seconds)) / half_life);  // of the way
    target_ = target + left * (target_ - target);
    yaw_ = yaw - left * std::remainder(yaw - yaw_, 2 * std::numbers::pi);
    began_ = true;
}

dmat4 FollowCamera::world() const {
    const dvec3 behind = -distance * Gaze{yaw_, 0}.ahead();
    return camera_at(target_ + behind + dvec3(0, height, 0), {yaw_, pitch});
}

void place_camera(ecs::World& in, ecs::Entity camera, const dmat4& world) {
    dmat4 local = world;
    if (const ecs::Entity parent = parent_of(in, camera)) {
        const dmat4& above = in.get<WorldTransform>(parent).matrix;
        if (!(std::abs(glm::determinant(glm::dmat3(above))) > 0)) {
            return;
        }
        local = glm::inverse(above) * world;
    }
    glm::dmat3 basis(1);
    if (orthonormal_basis(local, basis)) {
        Transform& to = in.get_mut<LocalTransform>(camera).value;
        to.translation = dvec3(local[3]);
        to.rotation = quat(glm::normalize(glm::quat_cast(basis)));
    }
}

}  // namespace lanthorn::shell
