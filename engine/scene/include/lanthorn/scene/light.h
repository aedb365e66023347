// Punctual lights in photometric units (KHR_lights_punctual).
#pragma once

#include <cstdint>
#include <limits>

#include "lanthorn/core/math.h"

namespace lanthorn {

// Where it shines from: far away in one direction, a point to all sides, or a point into a cone.
enum class LightType : std::uint8_t { directional, point, spot };

// A light shines along its node's -Z axis.
struct Light {
    LightType type = LightType::point;
    vec3 colour{1};                                        // linear RGB
    float intensity = 1;                                   // lux (directional) or candela (point, spot)
    float range = std::numeric_limits<float>::infinity();  // metres; infinite: no cut-off
    float inner_cone = 0;                                  // radians, spot; 0 <= inner < outer
    float outer_cone = kPi / 4;                            // radians, spot; <= pi/2

    bool operator==(const Light&) const = default;
};

}  // namespace lanthorn
