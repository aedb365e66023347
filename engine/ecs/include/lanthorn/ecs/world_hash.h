// Hashes of a world's state, a part a declared component or resource: equal state has equal hashes on the
// same build, and a difference says where it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

// The parts of the state: "entities" (which are alive), every component and every resource that is not
// transient, in the order of declaration.
std::vector<std::string> state_parts(const Registry& registry);

// One number a part, which says what its hash is of: names, types and choices of the fields that count. Equal
// on every build that declares the part alike.
std::vector<std::uint64_t> state_schemas(const Registry& registry);

// One hash a part (XXH3, 64 bits): of the fields that are not transient, by their bits and without padding,
// entity by entity in the order of their indices; where rows lie does not matter. Throws Error for a
// component that is not declared. O(bytes of state).
std::vector<std::uint64_t> state_hashes(const Registry& registry, const World& world);

// What differs in the state of two worlds, field by field: "door of entity 3v1: open_angle is 1.5, expected
// 1.25". At most `most` lines.
std::vector<std::string> state_differences(const Registry& registry, const World& found,
                                           const World& expected, std::size_t most = 20);

}  // namespace lanthorn::ecs
