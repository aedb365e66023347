// Where an entity is in the world after what this step has moved so far, of which WorldTransform does not
// know yet.
#pragma once

#include "lanthorn/ecs/lookup.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::game {

using Places = ecs::Lookup<ecs::Read<LocalTransform>, ecs::Read<Parent>>;

// Object to world. O(depth).
inline dmat4 place_now(const Places& of, ecs::Entity e) {
    dmat4 place(1);
    while (const LocalTransform* local = of.try_get<LocalTransform>(e)) {
        place = local->value.matrix() * place;
        const Parent* above = of.try_get<Parent>(e);
        if (above == nullptr) {
            break;
        }
        e = above->entity;
    }
    return place;
}

}  // namespace lanthorn::game
