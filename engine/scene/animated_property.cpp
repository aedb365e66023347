#include "lanthorn/scene/animated_property.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace lanthorn {

namespace {

using enum AnimatedProperty;

constexpr double kMost = std::numeric_limits<float>::max();
constexpr double kLeast = 1e-6;  // of what must be more than 0

float within(double value, double low, double high) {
    return static_cast<float>(std::clamp(value, low, high));
}

vec3 colour(const PropertyValue& value, double high) {
    return {within(value[0], 0, high), within(value[1], 0, high), within(value[2], 0, high)};
}

PropertyValue one(double value) {
    return {value, 0, 0, 0};
}

PropertyValue three(const vec3& v) {
    return {v.x, v.y, v.z, 0};
}

}  // namespace

PropertyOwner owner_of(AnimatedProperty property) {
    return property <= light_outer_cone ? PropertyOwner::light
           : property <= camera_z_far   ? PropertyOwner::camera
                                        : PropertyOwner::material;
}

std::uint32_t width_of(AnimatedProperty property) {
    switch (property) {
        case base_colour:
            return 4;
        case light_colour:
        case emissive:
        case specular_colour:
        case attenuation_colour:
            return 3;
        default:
            return 1;
    }
}

PropertyValue property_of(const Light& light, AnimatedProperty property) {
    switch (property) {
        case light_colour:
            return three(light.colour);
        case light_intensity:
            return one(light.intensity);
        case light_range:
            return one(light.range);
        case light_inner_cone:
            return one(light.inner_cone);
        default:
            assert(property == light_outer_cone);
            return one(light.outer_cone);
    }
}

void set_property(Light& light, AnimatedProperty property, const PropertyValue& value) {
    switch (property) {
        case light_colour:
            light.colour = colour(value, kMost);
            break;
        case light_intensity:
            light.intensity = within(value[0], 0, kMost);
            break;
        case light_range:
            light.range = within(value[0], kLeast, kMost);
            break;
        case light_inner_cone:
            light.inner_cone = within(value[0], 0, kPi / 2);
            break;
        default:
            assert(property == light_outer_cone);
            light.outer_cone = within(value[0], 1e-3, kPi / 2);
    }
    light.inner_cone = std::min(light.inner_cone, light.outer_cone * 0.999f);
}

PropertyValue property_of(const Camera& camera, AnimatedProperty property) {
    switch (property) {
        case camera_y_fov:
            return one(camera.y_fov);
        case camera_x_mag:
            return one(camera.x_mag);
        case camera_y_mag:
            return one(camera.y_mag);
        case camera_z_near:
            return one(camera.z_near);
        default:
            assert(property == camera_z_far);
            return one(camera.z_far);
    }
}

void set_property(Camera& camera, AnimatedProperty property, const PropertyValue& value) {
    switch (property) {
        case camera_y_fov:
            camera.y_fov = within(value[0], 1e-3, kPi - 1e-3);
            break;
        case camera_x_mag:
            camera.x_mag = within(value[0], kLeast, kMost);
            break;
        case camera_y_mag:
            camera.y_mag = within(value[0], kLeast, kMost);
            break;
        case camera_z_near:
            camera.z_near = within(value[0], camera.orthographic ? 0 : kLeast, kMost);
            break;
        default:
            assert(property == camera_z_far);
            camera.z_far = within(value[0], 0, kMost);
    }
    if (camera.z_far != 0 || camera.orthographic) {
        camera.z_far = std::max(camera.z_far, camera.z_near * 1.001f + static_cast<float>(kLeast));
    }
}

PropertyValue property_of(const Material& material, AnimatedProperty property) {
    switch (property) {
        case base_colour:
            return {material.base_colour.x, material.base_colour.y, material.base_colour.z,
                    material.base_colour.w};
        case metallic:
            return one(material.metallic);
        case roughness:
            return one(material.roughness);
        case emissive:
            return three(material.emissive);
        case emissive_scale:
            return one(1);
        case normal_scale:
            return one(material.normal_scale);
        case occlusion_strength:
            return one(material.occlusion_strength);
        case alpha_cutoff:
            return one(material.alpha_cutoff);
        case ior:
            return one(material.ior);
        case specular:
            return one(material.specular);
        case specular_colour:
            return three(material.specular_colour);
        case transmission:
            return one(material.transmission);
        case thickness:
            return one(material.thickness);
        case attenuation_distance:
            return one(material.attenuation_distance);
        default:
            assert(property == attenuation_colour);
            return three(material.attenuation_colour);
    }
}

void set_property(Material& material, AnimatedProperty property, const PropertyValue& value) {
    switch (property) {
        case base_colour:
            material.base_colour = vec4(colour(value, 1), within(value[3], 0, 1));
            break;
        case metallic:
            material.metallic = within(value[0], 0, 1);
            break;
        case roughness:
            material.roughness = within(value[0], 0, 1);
            break;
        case emissive:
            material.emissive = colour(value, kMost);
            break;
        case normal_scale:
            material.normal_scale = within(value[0], -kMost, kMost);
            break;
        case occlusion_strength:
            material.occlusion_strength = within(value[0], 0, 1);
            break;
        case alpha_cutoff:
            material.alpha_cutoff = within(value[0], 0, kMost);
            break;
        case ior:
            // 0 is glTF's way to say that all light is reflected (material.h).
            material.ior = value[0] == 0 ? 1e3f : within(value[0], 1, 1e3);
            break;
        case specular:
            material.specular = within(value[0], 0, 1);
            break;
        case specular_colour:
            material.specular_colour = colour(value, kMost);
            break;
        case transmission:
            material.transmission = within(value[0], 0, 1);
            break;
        case thickness:
            material.thickness = within(value[0], 0, kMost);
            break;
        case attenuation_distance:
            material.attenuation_distance = within(value[0], 0, kMost);
            break;
        default:
            assert(property == attenuation_colour);
            material.attenuation_colour = colour(value, 1);
    }
}

}  // namespace lanthorn
