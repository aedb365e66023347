// Rigid bodies that the player walks against.
#include <algorithm>

#include "game/rules/systems.h"

namespace lanthorn::game {

void shove_bodies(Res<Intent> intent, Res<SharedPhysics> physics,
                  Query<Read<physics::RigidBody>, Mut<physics::BodyMotion>, Read<WorldTransform>> bodies) {
    constexpr double kTouch = 0.05;   // metres between her and what she shoves
    constexpr double kSpeed = 1.2;    // metres a second that she brings what is light to
    constexpr double kMomentum = 10;  // kilograms times metres a second: what is heavy goes slower
    const double walks = glm::length(intent->walk);
    if (!(walks > 0)) {
        return;
    }
    const dvec3 way = intent->walk / walks;
    bodies.each([&](Entity e, const physics::RigidBody& body, ecs::MutRef<physics::BodyMotion> motion,
                    const WorldTransform& world) {
        if (body.type != physics::BodyType::dynamic) {
            return;
        }
        const double most = std::min({walks, kSpeed, kMomentum / body.mass});
        const double lacks = most - glm::dot(motion->linear, way);
        dmat4 nearer = world.matrix;
        nearer[3] -= dvec4(kTouch * way, 0);
        // Not what she stands on.
        const bool ahead =
            glm::dot((*physics)->centre(e).value_or(dvec3(world.matrix[3])) - intent->feet, way) > 0;
        if (lacks > 0 && ahead && (*physics)->would_overlap(e, nearer, intent->player)) {
            motion.write().linear += lacks * way;
        }
    });
}

}  // namespace lanthorn::game
