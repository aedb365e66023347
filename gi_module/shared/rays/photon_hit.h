// A photon that has arrived.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// What is splatted, as shaders read it.
struct PhotonHit {
    vec3 position;
    float radius;          // bandwidth h in metres; 0: no photon
    vec3 power;            // rgb in lumen
    std::uint32_t normal;  // octahedral, 2 x snorm16
};
static_assert(sizeof(PhotonHit) == 32 && offsetof(PhotonHit, radius) == 12 &&
              offsetof(PhotonHit, power) == 16 && offsetof(PhotonHit, normal) == 28);

}  // namespace lanthorn::gi
