#include "engine/scene/described.h"

#include "lanthorn/scene/components.h"

namespace lanthorn {

std::string described(const ecs::World& world, ecs::Entity e) {
    const Name* name = world.try_get<Name>(e);
    return name ? ecs::to_string(e) + " '" + name->value + "'" : ecs::to_string(e);
}

}  // namespace lanthorn
