// The sky among the lit texels. The C++ side: sky_places.h.
#ifndef LANTHORN_EMC_SKY_PLACES_GLSL
#define LANTHORN_EMC_SKY_PLACES_GLSL

#include "engine/render/octahedral.glsl"

const int kSkySide = 32;

uniform int sky_first;  // place of the first cell

// What a ray in direction d has met that meets nothing.
uint sky_place_of(vec3 d) {
    ivec2 p = min(ivec2((octahedral_encode(d) * 0.5 + 0.5) * float(kSkySide)), ivec2(kSkySide - 1));
    return uint(sky_first + p.y * kSkySide + p.x);
}

#endif
