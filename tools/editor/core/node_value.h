// What a node, a material or a light says in one of its fields.
#pragma once

#include <string>
#include <string_view>

#include "lanthorn/ecs/registry.h"
#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// As JSON text. `field`: name, parent (its path), visible, translation, rotation (x, y, z, w), scale,
// light.F, camera.F (their declared fields, and light.lumen, light.lux, light.kelvin), COMPONENT, COMPONENT.F
// (what the extras leave out has its default), extras, extras.KEY. Throws InputError for what the node has
// not.
std::string node_value(const EditModel& model, const ecs::Registry& registry, std::uint32_t node,
                       std::string_view field);
// A factor of a material: as set-material takes it.
std::string material_value(const EditModel& model, std::string_view material, std::string_view field);

// Whether two JSON texts say the same: numbers to a relative 1e-6.
bool means_the_same(std::string_view a, std::string_view b);

}  // namespace lanthorn::editor
