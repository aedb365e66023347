// Rays that are remembered: kRemembered slots of `rays` for each of `capacity` keys, where a key is the place of a point in the
// picture's grid or in the lit maps. The rays of a slot have one start. The C++ side: remembered_hits.h.
#ifndef LANTHORN_EMC_REMEMBERED_GLSL
#define LANTHORN_EMC_REMEMBERED_GLSL

#include "gi_module/techniques/emc/lit_maps/lit_hits.glsl"
#include "point_lists.glsl"

#ifndef SLOTS
#define SLOTS 16  // RememberedHits::kFrames
#endif
const uint kRemembered = uint(SLOTS);

const uint kCarried = 0x80000000u;  // beside the place of a start among those of its cell: a mover has carried it along

uniform int rays;      // a point and frame
uniform int capacity;  // keys

// Where each ray, or each start, has an invocation: x is the key, y the row, so that nothing is divided.
uint item_key() { return gl_GlobalInvocationID.x; }
uint item_row() { return gl_GlobalInvocationID.y; }

uint entry_of(uint slot, uint j, uint key) { return (slot * uint(rays) + j) * uint(capacity) + key; }
uint start_of(uint slot, uint key) { return slot * uint(capacity) + key; }
int start_of(uint entry) { return int(start_of(entry / uint(rays * capacity), entry % uint(capacity))); }

// A direction in 32 bits; what is traced is what comes out again.
uint pack_direction(vec3 d) { return packSnorm2x16(octahedral_encode(d)); }
vec3 unpack_direction(uint bits) { return octahedral_decode(unpackSnorm2x16(bits)); }

#endif
