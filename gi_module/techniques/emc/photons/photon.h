// Photons as the passes hand them on. The GLSL side: photon.glsl.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gi_module/shared/rays/photon_hit.h"
#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// A photon leaving a surface.
struct PhotonRay {
    vec3 origin;
    std::uint32_t start;  // its surface's normal, and the map to ask first
    vec4 direction;       // xyz unit; w = its density over 1 / pi (surface_bsdf.glsl), 0: lost
    vec3 power;           // rgb in lumen
    std::uint32_t
        number;  // of its random numbers: depends on its light and its place among that light's photons alone
};
static_assert(sizeof(PhotonRay) == 48 && offsetof(PhotonRay, direction) == 16 &&
              offsetof(PhotonRay, power) == 32 && offsetof(PhotonRay, number) == 44);

}  // namespace lanthorn::gi
