// Alterations of a world's state of which nothing is known but its declaration.
#pragma once

#include <cstdint>
#include <string>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::tools {

// The lowest bit of one field of that part, or its next value; `number` chooses entity and field. A component
// without fields is taken away. Says what was altered; empty: nothing of the kind is there.
std::string flip_bit(const ecs::Registry& registry, ecs::World& world, const std::string& part,
                     std::uint64_t number);

// Two entities whose components of that name differ exchange them. Says which; empty: there are no two.
std::string swap_two(const ecs::Registry& registry, ecs::World& world, const std::string& part,
                     std::uint64_t number);

// Whether state has such a part, other than "entities".
bool has_part(const ecs::Registry& registry, const std::string& part);

}  // namespace lanthorn::tools
