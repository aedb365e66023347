// In which fields of which entities two worlds differ, to the last number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::tools {

struct FieldDifference {
    std::string part;    // "body_motion"
    std::string entity;  // "crate-3 (17v1)"; empty: of a resource
    std::string field;   // "angular.y"; empty: the component is there in one world alone
    std::string found, expected;
    int sign = 0;            // of found - expected, where both are numbers
    std::uint64_t ulps = 0;  // between floating-point numbers of one sign; 0: does not apply
    ecs::Entity id;          // of `entity`; null: of a resource

    // "body_motion.angular.y"
    std::string name() const { return field.empty() ? part : part + "." + field; }
};

// State alone, in the order of declaration and of entities; at most `most`. Both worlds must be declared by
// registries of one program.
std::vector<FieldDifference> field_differences(const ecs::Registry& registry, const ecs::World& found,
                                               const ecs::World& expected, std::size_t most);

}  // namespace lanthorn::tools
