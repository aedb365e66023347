// One emissive triangle as the shaders read it (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_EMISSIVE_DATA_H
#define LANTHORN_EMISSIVE_DATA_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

namespace lanthorn::render {
#endif

const uint kEmissiveBinding = 3u;  // storage buffer binding of the EmissiveTriangleData array

// A triangle that emits, as shaders read it.
struct EmissiveTriangleData {
    vec4 p0;        // render space; w = cumulative share of the flux up to and including this triangle, 0..1
    vec4 p1;        // counter-clockwise seen from the front; w = 1 if both sides emit, else 0
    vec4 p2;        // w = luminance-weighted flux of this triangle in lumen, both sides where both emit
    vec4 radiance;  // nits, rgb; w = area in m^2
};

#ifdef __cplusplus
static_assert(sizeof(EmissiveTriangleData) == 64);
}  // namespace lanthorn::render
#endif
#endif
