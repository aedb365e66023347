#include "game/level/reveal.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <vector>

#include "game/rules/components.h"
#include "game/rules/systems.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::game {

namespace {

constexpr double kClear = 0.25;  // metres: the camera's ball
constexpr double kOwn = 0.45;    // metres around a crystal that are its own body

struct Woken {
    std::set<ecs::Entity> awake;
    int all = 0;
};

Woken look_for_woken(const ecs::World& world) {
    Woken found;
    const auto add = [&](ecs::Entity e, bool done) {
        ++found.all;
        if (done) {
            found.awake.insert(e);
        }
    };
    world.query<ecs::Read<Crystal>>().each(
        [&](ecs::Entity e, const Crystal& crystal) { add(e, crystal.awake); });
    world.query<ecs::Read<Goal>>().each([&](ecs::Entity e, const Goal& goal) { add(e, goal.reached); });
    return found;
}

// Around what is shown: how far the view's direction is turned from its front, metres, degrees above it.
struct Seat {
    double turn, away, rise;
};
constexpr Seat kSeats[] = {{30, 2.3, 12}, {-30, 2.3, 12}, {55, 2.3, 14}, {-55, 2.3, 14}, {10, 2.1, 18},
                           {30, 1.6, 12}, {-30, 1.6, 12}, {60, 1.6, 14}, {-60, 1.6, 14}, {5, 1.4, 20},
                           {80, 1.5, 16}, {-80, 1.5, 16}, {0, 1.0, 15},  {120, 1.6, 25}, {-120, 1.6, 25}};

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

void Reveal::begin(const ecs::World& world) {
    const Woken now = look_for_woken(world);
    awake_ = now.awake;
    all_ = now.all;
    target_.reset();
}

void Reveal::watch(const ecs::World& world) {
    const Woken now = look_for_woken(world);
    for (const ecs::Entity e : now.awake) {
        if (!awake_.contains(e)) {
            start(world, e);
        }
    }
    awake_ = now.awake;
    all_ = now.all;
}

// From the seat that is nearest to where the player looked from, of those with nothing before what is shown.
void Reveal::start(const ecs::World& world, ecs::Entity target) {
    const auto* physics = world.try_resource<SharedPhysics>();
    const ecs::Entity camera = world.resource<View>().camera;
    if (physics == nullptr || !camera || !world.has<WorldTransform>(camera)) {
        return;
    }
    const dmat4& seen_from = world.get<WorldTransform>(camera).matrix;
    const dmat4& at = world.get<WorldTransform>(target).matrix;
    const ecs::Entity player = world.resource<Intent>().player;
    const std::span<const ecs::Entity> without(&player, player ? 1 : 0);
    const dvec3 centre(at[3]), here(seen_from[3]);
    dvec3 front = -dvec3(at[2]);
    front.y = 0;
    front = glm::length(front) > 1e-3 ? glm::normalize(front) : glm::normalize(here - centre);
    way_ = {here, here, -glm::normalize(dvec3(seen_from[2]))};
    double best = 1e9;
    for (const Seat& seat : kSeats) {
        const dmat4 turned = glm::rotate(dmat4(1), glm::radians(seat.turn), dvec3(0, 1, 0));
        const double rise = glm::radians(seat.rise);
        const dvec3 out = dvec3(turned * dvec4(front * std::cos(rise), 0)) + dvec3(0, std::sin(rise), 0);
        const dvec3 place = centre + seat.away * out;
        const double free = (*physics)->sweep_sphere(centre + kOwn * out, place, kClear, without).share;
        // Far from what is shown it is small: a metre less of that is worth as much as two of the way.
        const double cost = glm::distance(place, here) + 2 * std::abs(seat.away - 2.3);
        if (free == 1 && cost < best) {
            best = cost;
            way_.to = place;
        }
    }
    // A way through walls is no way: then the picture is there at once, a little farther off, and comes near.
    if ((*physics)->sweep_sphere(here, way_.to, kClear, without).share < 1) {
        const dvec3 back = 0.3 * (way_.to - centre);
        const double share = (*physics)->sweep_sphere(way_.to, way_.to + back, kClear, without).share;
        way_.from = way_.to + share * back;
        way_.from_aim = glm::normalize(centre - way_.from);
    }
    target_ = centre;
    seconds_ = 0;
}

void Reveal::pass(double seconds, bool stays) {
    seconds_ += seconds;
    if (showing() && !stays && seconds_ > kEase + kHold) {
        release();
    }
}

void Reveal::look(ShownScene& level) {
    const ecs::World& world = level.world();
    const ecs::Entity camera = level.camera();
    if (!camera || level.frame().instances.empty()) {
        return;
    }
    const double share = smooth(seconds_ / kEase);
    const dvec3 from = glm::mix(way_.from, way_.to, share);
    const dvec3 aim = glm::normalize(*target_ - from);
    // Past what lies behind her the short way round has no side: the plain mix has one by rounding.
    dvec3 look = glm::mix(way_.from_aim, aim, share);
    look = glm::length(look) > 1e-3 ? glm::normalize(look) : aim;
    const dvec3 up = std::abs(look.y) > 0.999 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    const dmat4 at = glm::inverse(glm::lookAt(from, from + look, up));
    level.app().view().placed =
        camera_view(world.get<CameraComponent>(camera).camera, at, level.frame().origin);
}

}  // namespace lanthorn::game
