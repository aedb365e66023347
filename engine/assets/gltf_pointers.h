// KHR_animation_pointer: the JSON pointers of what clips move of lights, cameras and materials.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/scene/animated_property.h"

namespace lanthorn {

struct PointedProperty {
    AnimatedProperty property = AnimatedProperty::light_intensity;
    std::uint32_t object = 0;  // index in the file's lights, cameras or materials
};

// "/materials/3/emissiveFactor" and the like; nothing for what is not animated here. Texture transforms,
// visibility and what extensions that are not read have, for example.
std::optional<PointedProperty> pointed_property(std::string_view pointer);

// The other way. `orthographic` tells the planes of the two kinds of cameras apart.
std::string pointer_to(const PointedProperty& target, bool orthographic);

}  // namespace lanthorn
