#include "tools/lanthorn/scene/moved_lights.h"

#include <cmath>

namespace lanthorn::tools {

bool MovedLights::add(ecs::Entity entity, bool turns) {
    const auto* parent = world_->try_get<Parent>(entity);
    const glm::dmat3 to_world =
        parent != nullptr ? glm::dmat3(world_->get<WorldTransform>(parent->entity).matrix) : glm::dmat3(1);
    const double volume = glm::determinant(to_world);
    if (volume == 0 || !std::isfinite(volume)) {
        return false;
    }
    lights_.push_back({entity, world_->get<LocalTransform>(entity).value, glm::inverse(to_world), turns});
    return true;
}

void MovedLights::move(double metres, double radians) {
    for (const Moved& light : lights_) {
        Transform& local = world_->get_mut<LocalTransform>(light.entity).value;
        if (light.turns) {
            local.rotation =
                glm::angleAxis(static_cast<float>(radians), vec3(0, 1, 0)) * light.still.rotation;
        } else {
            local.translation = light.still.translation + light.to_local * dvec3(metres, 0, 0);
        }
    }
}

}  // namespace lanthorn::tools
