// A caustic photon on its way from a light to the first thing that mirrors it or lets it through, and where
// such photons arrive.
#pragma once

#include <cstdint>
#include <vector>

#include "gi_module/shared/rays/photon_hit.h"

namespace lanthorn::gi {

struct CausticPhoton {
    vec3 origin{0};
    std::uint32_t target =
        0;  // that it is aimed at: it counts only if it meets a part of that one first; kAround: at none
    vec3 direction{0};      // unit
    std::uint32_t key = 0;  // with `number`: of its random numbers
    vec3 power{0};          // rgb in lumen
    std::uint32_t number = 0;
    float range = 0;  // metres after which its light ends (KHR_lights_punctual), 1e30: never
    float unused[3] = {};

    static constexpr std::uint32_t kAround = 0xffffffffu;
};

// Where caustic photons arrive.
struct CausticArrivals {
    std::vector<PhotonHit> straight;   // light that has met mirrors and glass alone
    std::vector<PhotonHit> scattered;  // light that something else has scattered, before them or after
};

}  // namespace lanthorn::gi
