// What clips move of lights, cameras and materials (KHR_animation_pointer): numbers, one to four of them.
#pragma once

#include <array>
#include <cstdint>

#include "lanthorn/scene/camera.h"
#include "lanthorn/scene/light.h"
#include "lanthorn/scene/material.h"

namespace lanthorn {

// One property of a light, camera or material that a clip's keys can be of.
enum class AnimatedProperty : std::uint8_t {
    light_colour,
    light_intensity,
    light_range,
    light_inner_cone,
    light_outer_cone,
    camera_y_fov,
    camera_x_mag,
    camera_y_mag,
    camera_z_near,
    camera_z_far,
    base_colour,
    metallic,
    roughness,
    emissive,        // nits
    emissive_scale,  // a factor on what `emissive` of the same clip says; nothing by itself
    normal_scale,
    occlusion_strength,
    alpha_cutoff,
    ior,
    specular,
    specular_colour,
    transmission,
    thickness,
    attenuation_distance,
    attenuation_colour
};

// What a property belongs to.
enum class PropertyOwner : std::uint8_t { light, camera, material };

// Which of them has it.
PropertyOwner owner_of(AnimatedProperty property);
// Numbers that it has.
std::uint32_t width_of(AnimatedProperty property);

using PropertyValue = std::array<double, 4>;

// What the property is now; 1 for emissive_scale. `property` must be the owner's.
PropertyValue property_of(const Light& light, AnimatedProperty property);
// The same of a camera.
PropertyValue property_of(const Camera& camera, AnimatedProperty property);
// The same of a material.
PropertyValue property_of(const Material& material, AnimatedProperty property);

// Sets it, moved into its range, which splines may leave. A colour may be brighter than 1, an inner cone is
// less than the outer one, a far plane is beyond the near one or 0. Not for emissive_scale.
void set_property(Light& light, AnimatedProperty property, const PropertyValue& value);
// The same of a camera.
void set_property(Camera& camera, AnimatedProperty property, const PropertyValue& value);
// The same of a material.
void set_property(Material& material, AnimatedProperty property, const PropertyValue& value);

}  // namespace lanthorn
