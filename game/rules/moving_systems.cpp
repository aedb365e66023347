// What the player slides, pushes and turns: shutters, things on rails, turntables.
#include <algorithm>
#include <cmath>

#include "game/rules/moved_bodies.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/core/turns.h"

namespace lanthorn::game {

namespace {

// In the axes that the node's translation has.
dvec3 in_parent(const WorldTransform& world, const Transform& local, const dvec3& direction) {
    return glm::inverse(glm::dmat3(world.matrix * glm::inverse(local.matrix()))) * direction;
}

}  // namespace

void slide_shutters(Res<Intent> intent, Res<SharedPhysics> physics,
                    Query<Mut<Shutter>, Mut<LocalTransform>, Read<WorldTransform>> shutters) {
    shutters.each([&](Entity e, ecs::MutRef<Shutter> state, ecs::MutRef<LocalTransform> local,
                      const WorldTransform& world) {
        if ((intent->pressed & kUse) != 0 && intent->in_reach(middle_of(e, world, **physics))) {
            state.write().open = !state->open;
        }
        const double target = state->open ? 1 : 0;
        if (state->share == target) {
            return;
        }
        const double most = kStepSeconds / state->seconds;
        const double share = state->share + std::clamp(target - state->share, -most, most);
        Transform to = local->value;
        to.translation = state->shut + share * state->way;
        if (!hits_player(e, world, local->value, to, *intent, **physics)) {
            state.write().share = share;
            local.write().value = to;
        }
    });
}

void push_along(Res<Intent> intent, Res<SharedPhysics> physics,
                Query<Mut<Pushed>, Mut<LocalTransform>, Read<WorldTransform>> things) {
    constexpr double kTouch = 0.04;  // metres between her and what she pushes
    constexpr double kSpeed = 0.9;   // metres a second, at most
    things.each([&](Entity e, ecs::MutRef<Pushed> state, ecs::MutRef<LocalTransform> local,
                    const WorldTransform& world) {
        const double length = glm::length(state->rail);
        if (intent->walk == dvec3(0) || !(length > 0)) {
            return;
        }
        const dvec3 along = state->rail / length;
        const double wish =
            std::clamp(glm::dot(in_parent(world, local->value, intent->walk), along), -kSpeed, kSpeed);
        // She is against it if it would meet her a touch nearer.
        Transform nearer = local->value;
        nearer.translation -= along * std::copysign(kTouch, wish);
        if (wish == 0 || !(*physics)->would_overlap(e, placed(world, local->value, nearer), intent->player)) {
            return;
        }
        const double share = std::clamp(state->share + wish * kStepSeconds / length, 0.0, 1.0);
        if (share != state->share) {
            state.write().share = share;
            local.write().value.translation = state->start + share * state->rail;
        }
    });
}

void turn_tables(Res<Intent> intent, Res<SharedPhysics> physics, Res<PlayerInput> input,
                 Query<Mut<Turntable>, Mut<LocalTransform>, Read<WorldTransform>> tables) {
    if ((input->held & kUse) == 0) {
        return;
    }
    tables.each([&](Entity e, ecs::MutRef<Turntable> state, ecs::MutRef<LocalTransform> local,
                    const WorldTransform& world) {
        if (!intent->in_reach(middle_of(e, world, **physics))) {
            return;
        }
        const double angle = std::remainder(state->angle + kStepSeconds * state->speed, 2 * double(kPi));
        Transform to = local->value;
        to.rotation = state->start * quat(about_y(angle));
        if (!hits_player(e, world, local->value, to, *intent, **physics)) {
            state.write().angle = angle;
            local.write().value = to;
        }
    });
}

}  // namespace lanthorn::game
