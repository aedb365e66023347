// Doors that swing.
#include <cmath>

#include "game/rules/moved_bodies.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/core/turns.h"

namespace lanthorn::game {

namespace {

constexpr double kSpring = 14;  // 1 / s^2

Transform turned(const Transform& local, const Door& door, double angle) {
    Transform at = local;
    at.rotation = door.closed * quat(about_y(angle));
    return at;
}

}  // namespace

void swing_doors(Res<Intent> intent, Res<SharedPhysics> physics,
                 Query<Mut<Door>, Mut<LocalTransform>, Read<WorldTransform>> doors) {
    doors.each([&](Entity e, ecs::MutRef<Door> state, ecs::MutRef<LocalTransform> local,
                   const WorldTransform& world) {
        if ((intent->pressed & kUse) != 0 && intent->in_reach(middle_of(e, world, **physics))) {
            state.write().open = !state->open;
        }
        const double target = state->open ? state->open_angle : 0;
        if (state->angle == target && state->speed == 0) {
            return;
        }
        Door& door = state.write();
        const double damping = 2 * std::sqrt(kSpring);  // critical: no overshoot
        door.speed += kStepSeconds * (kSpring * (target - door.angle) - damping * door.speed);
        double next = door.angle + kStepSeconds * door.speed;
        if (std::abs(next - target) < 1e-3 && std::abs(door.speed) < 1e-2) {
            next = target;
            door.speed = 0;
        }
        const Transform at = turned(local->value, door, next);
        if (hits_player(e, world, local->value, at, *intent, **physics)) {
            door.speed = 0;
            return;
        }
        door.angle = next;
        local.write().value = at;
    });
}

}  // namespace lanthorn::game
