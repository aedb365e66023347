// Rays that are remembered: kRemembered slots of `rays` for each of `capacity` keys, where a key is the place of a point in the
// picture's grid or in the lit maps. The C++ side: remembered_hits.h.
#ifndef LANTHORN_EMC_REMEMBERED_GLSL
#define LANTHORN_EMC_REMEMBERED_GLSL

#include "lit_hits.glsl"
#include "point_lists.glsl"

const uint kRemembered = 16u;  // RememberedHits::kFrames

uniform int rays;      // a point and frame
uniform int capacity;  // keys

uint entry_of(uint slot, uint j, uint key) { return (slot * uint(rays) + j) * uint(capacity) + key; }
uint entry_count() { return kRemembered * uint(rays) * uint(capacity); }

// A direction in 32 bits; what is traced is what comes out again.
uint pack_direction(vec3 d) { return packSnorm2x16(octahedral_encode(d)); }
vec3 unpack_direction(uint bits) { return octahedral_decode(unpackSnorm2x16(bits)); }

#endif
