// What glTF nodes' extras say of components, and back.
//
//   {"door": {"open_angle": 1.9}, "author": "Ann"}    // a component, and somebody else's
//
// Which keys are components: see lanthorn/ecs/component_json.h (ExtrasReading). References to entities
// are the names of nodes; among nodes of one name it is the first of them that is meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn {

// What to do with extras that do not fit a component's declaration.
enum class BadExtras {
    refuse,  // nothing is added, the first problem is thrown
    skip,    // a component with a problem is left out, an unknown field is ignored
};

// Adds the components that the entities' Extras name; a component that an entity has already is replaced.
// `entities` are a scene's nodes as spawn() returned them, `source` the file they came from. Returns what was
// wrong, each one line: "level.glb: node 'leaf': door.open_angle is 5, expected a number from 0 to 3.1 rad".
// Throws InputError with the first of these lines if they are to be refused. O(length of the extras).
std::vector<std::string> apply_extras(ecs::World& world, const ecs::Registry& registry,
                                      std::span<const ecs::Entity> entities, std::string_view source,
                                      BadExtras bad = BadExtras::refuse);

// Entities by their Name: what references in a scene's extras mean.
ecs::EntityNames names_of(const ecs::World& world, std::span<const ecs::Entity> entities);

}  // namespace lanthorn
