#include "lanthorn/scene/material.h"

#include <algorithm>
#include <cmath>

namespace lanthorn {

vec3 Material::absorption() const {
    if (attenuation_distance <= 0) {
        return vec3(0);
    }
    constexpr float kLeast = 1e-7f;  // black after that distance: its logarithm has an end
    vec3 result;
    for (int i = 0; i < 3; ++i) {
        result[i] = -std::log(std::max(attenuation_colour[i], kLeast)) / attenuation_distance;
    }
    return glm::max(result, vec3(0));  // and no -0
}

}  // namespace lanthorn
