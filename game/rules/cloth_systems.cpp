// Curtains and other cloths: their joints follow their points.
#include "game/rules/systems.h"

namespace lanthorn::game {

void swing_cloths(Res<Intent> intent, ecs::Lookup<Read<physics::Character>> characters,
                  Query<Write<Cloth>, Read<SkinInstance>, Read<WorldTransform>> cloths,
                  ecs::Lookup<Write<LocalTransform>> joints) {
    constexpr double kGravity = 9.81;  // m/s^2
    const auto* body = characters.try_get<physics::Character>(intent->player);
    cloths.each([&](Cloth& cloth, const SkinInstance& skin, const WorldTransform& world) {
        const dmat4 to_cloth = glm::inverse(world.matrix);
        Pillar player;
        if (body != nullptr) {
            player = {dvec3(to_cloth * dvec4(intent->feet, 1)), body->radius, body->height};
        }
        const dvec3 down = glm::dmat3(to_cloth) * dvec3(0, -kGravity, 0);
        if (!step_cloth(cloth, down, body != nullptr ? &player : nullptr)) {
            return;
        }
        for (std::size_t i = cloth.columns; i < cloth.points.size(); ++i) {
            if (LocalTransform* joint = joints.try_get_mut<LocalTransform>(skin.joints[i])) {
                joint->value.translation = cloth.points[i];
            }
        }
    });
}

}  // namespace lanthorn::game
