// What systems ask before they move a body by hand: where it would be, and whether the player is in the way.
#pragma once

#include "game/rules/systems.h"

namespace lanthorn::game {

// Object to world if its node's local transform were `to` instead of `from`.
inline dmat4 placed(const WorldTransform& world, const Transform& from, const Transform& to) {
    return world.matrix * glm::inverse(from.matrix()) * to.matrix();
}

// Whether going from `from` to `to` would run into the player.
inline bool hits_player(Entity e, const WorldTransform& world, const Transform& from, const Transform& to,
                        const Intent& intent, const physics::Physics& physics) {
    return physics.would_overlap(e, placed(world, from, to), intent.player) &&
           !physics.would_overlap(e, world.matrix, intent.player);
}

// Of its colliders; its origin where it has none.
inline dvec3 middle_of(Entity e, const WorldTransform& world, const physics::Physics& physics) {
    return physics.centre(e).value_or(dvec3(world.matrix[3]));
}

}  // namespace lanthorn::game
