#include "engine/physics/placement.h"

#include <cmath>

#include "lanthorn/scene/transforms.h"

namespace lanthorn::physics {

Placement placement_of(const dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    glm::dmat3 axes;
    axes[0] = glm::normalize(linear[0]);
    axes[1] = glm::normalize(linear[1] - axes[0] * glm::dot(axes[0], linear[1]));
    axes[2] = glm::cross(axes[0], axes[1]);
    Placement result;
    result.position = dvec3(matrix[3]);
    result.rotation = glm::normalize(glm::quat_cast(axes));
    result.stretch = glm::transpose(axes) * linear;
    return result;
}

bool is_finite(const Placement& p) {
    double sum = p.position.x + p.position.y + p.position.z;
    for (int i = 0; i < 3; ++i) {
        sum += p.stretch[i].x + p.stretch[i].y + p.stretch[i].z;
    }
    return std::isfinite(sum + p.rotation.w + p.rotation.x + p.rotation.y + p.rotation.z);
}

ExactPoint exact_point(const dvec3& relative, const dvec3& origin) {
    const dvec3 whole = glm::round(relative);
    return {origin + whole, relative - whole};
}

dvec3 relative_to(const dvec3& origin, const ExactPoint& point) {
    return point.whole - origin + point.rest;
}

dmat4 current_matrix(const ecs::World& world, ecs::Entity e) {
    const Shear* shear = world.try_get<Shear>(e);
    const dmat4 local =
        local_matrix(world.get<LocalTransform>(e).value, shear != nullptr ? shear->value : mat3(1));
    const Parent* parent = world.try_get<Parent>(e);
    const WorldTransform* above = parent != nullptr ? world.try_get<WorldTransform>(parent->entity) : nullptr;
    return above != nullptr ? above->matrix * local : local;
}

Transform local_of(const ecs::World& world, ecs::Entity e, const dvec3& position,
                   const glm::dquat& rotation) {
    Transform local = world.get<LocalTransform>(e).value;
    const Parent* parent = world.try_get<Parent>(e);
    const WorldTransform* above = parent != nullptr ? world.try_get<WorldTransform>(parent->entity) : nullptr;
    if (above == nullptr) {
        local.translation = position;
        local.rotation = quat(rotation);
        return local;
    }
    local.translation = dvec3(glm::inverse(above->matrix) * dvec4(position, 1));
    local.rotation = quat(glm::normalize(glm::conjugate(placement_of(above->matrix).rotation) * rotation));
    return local;
}

}  // namespace lanthorn::physics
