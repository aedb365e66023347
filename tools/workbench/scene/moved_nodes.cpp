#include "tools/workbench/scene/moved_nodes.h"

#include <cmath>

namespace lanthorn::workbench {

bool MovedNodes::add(ecs::Entity entity, bool turns) {
    const auto* parent = world_->try_get<Parent>(entity);
    const glm::dmat3 to_world =
        parent != nullptr ? glm::dmat3(world_->get<WorldTransform>(parent->entity).matrix) : glm::dmat3(1);
    const double volume = glm::determinant(to_world);
    if (volume == 0 || !std::isfinite(volume)) {
        return false;
    }
    nodes_.push_back({entity, world_->get<LocalTransform>(entity).value, glm::inverse(to_world), turns});
    return true;
}

void MovedNodes::move(const dvec3& metres, double radians) {
    for (const Moved& node : nodes_) {
        Transform& local = world_->get_mut<LocalTransform>(node.entity).value;
        if (node.turns) {
            local.rotation = glm::angleAxis(static_cast<float>(radians), vec3(0, 1, 0)) * node.still.rotation;
        } else {
            local.translation = node.still.translation + node.to_local * metres;
        }
    }
}

}  // namespace lanthorn::workbench
