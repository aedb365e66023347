// Parts of load_level(), each for things of one kind. They throw InputError, naming file and node.
#pragma once

#include <string>

#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

[[noreturn]] void fail(const ecs::World& world, ecs::Entity e, const std::string& source,
                       const std::string& problem);

// The first clip that no figure has for its own plays all the time.
void start_clip(ecs::World& world, const std::string& source);
// Figures, hands, followers, and the camera behind the player. After the player.
void start_figures(ecs::World& world, const std::string& source);
void start_cloths(ecs::World& world, const std::string& source);

}  // namespace lanthorn::game
