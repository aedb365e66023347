// Normals in 2 x 16 bits, as octahedral.glsl has them.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

inline std::uint32_t pack_normal(const vec3& n) {
    const float l1 = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    vec2 p = l1 > 0 ? vec2(n.x, n.y) / l1 : vec2(0);
    if (n.z < 0) {
        const vec2 folded(1 - std::abs(p.y), 1 - std::abs(p.x));
        p = {p.x >= 0 ? folded.x : -folded.x, p.y >= 0 ? folded.y : -folded.y};
    }
    return glm::packSnorm2x16(p);
}

// Unit.
inline vec3 unpack_normal(std::uint32_t packed) {
    const vec2 p = glm::unpackSnorm2x16(packed);
    const float z = 1 - std::abs(p.x) - std::abs(p.y);
    return glm::normalize(z >= 0 ? vec3(p, z)
                                 : vec3((1 - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f),
                                        (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f), z));
}

}  // namespace lanthorn::gi
