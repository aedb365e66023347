// What is mirrored in the picture, or seen through it: rays from its pixels and where they end.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// A ray from what a pixel shows, towards what is mirrored there or seen through it.
struct SpecularRay {
    vec3 origin{0};
    std::uint32_t pixel = 0;  // y * width + x
    vec3 direction{0};        // unit
    // 1: it has yet to meet the surface of the pixel, right ahead, and goes through it. Plus 2 times 0 to 15:
    // which of 16 directions of a rough surface's lobe it takes.
    std::uint32_t through = 0;
};
static_assert(sizeof(SpecularRay) == 32 && offsetof(SpecularRay, pixel) == 12 &&
              offsetof(SpecularRay, direction) == 16 && offsetof(SpecularRay, through) == 28);

// SpecularHit::kind: what it meets.
inline constexpr std::uint32_t kNothingKnown = 0;
inline constexpr std::uint32_t kMetSurface = 1;
inline constexpr std::uint32_t kMetSky = 2;

// Where it ends, after mirrors and glass: what sends light back along it. Where glass both mirrors and lets
// through it ends in several places. specular.glsl has the same.
struct SpecularHit {
    vec3 position{0};
    std::uint32_t kind = kNothingKnown;
    vec3 normal{0};    // of the surface, unit, on the ray's side; of the sky: the direction towards it
    float spread = 0;  // 1: on the way it took one direction of a lobe; the mean of its neighbours tells more
    vec3 reflectance{0};        // of even light, times what is left on the way; of the sky: that alone
    std::uint32_t emitter = 0;  // Instance::id + 1 of what it has met; 0: not known
    vec3 emission{0};           // radiance, nits, times what is left on the way
    std::uint32_t next = 0;     // index of another end of the same ray; 0: there is none
};
static_assert(sizeof(SpecularHit) == 64 && offsetof(SpecularHit, kind) == 12 &&
              offsetof(SpecularHit, normal) == 16 && offsetof(SpecularHit, reflectance) == 32 &&
              offsetof(SpecularHit, emission) == 48 && offsetof(SpecularHit, next) == 60);

}  // namespace lanthorn::gi
