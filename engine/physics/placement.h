// Where a body is: the parts of an object-to-world matrix that physics moves, and those that it keeps.
#pragma once

#include "engine/core/finite.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::physics {

// matrix = translate(position) * rotation * stretch.
struct Placement {
    dvec3 position{0};                // metres, world space
    glm::dquat rotation{1, 0, 0, 0};  // unit
    glm::dmat3 stretch{1};            // scale, and shear where there is any; mirrors too
};

// The rotation is that of the matrix's columns made square one after the other (Gram and Schmidt). A matrix
// with columns of no length or not finite: NaN in the result.
Placement placement_of(const dmat4& matrix);
bool is_finite(const Placement& placement);
using lanthorn::is_finite;

// To and from Bullet's space, whose `origin` is whole metres: no bit is lost.
ExactPoint exact_point(const dvec3& relative, const dvec3& origin);
dvec3 relative_to(const dvec3& origin, const ExactPoint& point);

// The object-to-world matrix as LocalTransform has it now, whether Transforms has run since or not; the
// parent's WorldTransform is taken as it is.
dmat4 current_matrix(const ecs::World& world, ecs::Entity e);

// The LocalTransform that brings an entity of `e`'s scale to a place in the world. Under a parent that is
// scaled unevenly or sheared the rotation is as near as a rotation can be.
Transform local_of(const ecs::World& world, ecs::Entity e, const dvec3& position, const glm::dquat& rotation);

}  // namespace lanthorn::physics
