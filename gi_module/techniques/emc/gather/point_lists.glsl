// Lists of surface points whose length the GPU alone knows, and the sizes of the indirect dispatches that work them off. Places
// in lists come from atomics: they decide which invocation does a point, never what it finds. The C++ side: surface_points.h.
#ifndef LANTHORN_EMC_POINT_LISTS_GLSL
#define LANTHORN_EMC_POINT_LISTS_GLSL

#include "engine/render/octahedral.glsl"
#include "engine/gpu/work_items.glsl"

const uint kNoPoint = 0xffffffffu;  // the key of a pixel that shows no surface

// A surface point: xyz in render space, w the bits of its octahedral normal.
vec4 pack_point(vec3 x, vec3 n) { return vec4(x, uintBitsToFloat(packSnorm2x16(octahedral_encode(n)))); }
vec3 point_normal(vec4 point) { return octahedral_decode(unpackSnorm2x16(floatBitsToUint(point.w))); }

#endif
