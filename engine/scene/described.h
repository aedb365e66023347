// How messages name an entity.
#pragma once

#include <string>

#include "lanthorn/ecs/world.h"

namespace lanthorn {

// "entity 12v3 'door'", or without the Name "entity 12v3"; of dead entities too.
std::string described(const ecs::World& world, ecs::Entity e);

}  // namespace lanthorn
