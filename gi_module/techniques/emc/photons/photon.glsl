// Photons as the passes hand them on. The C++ side: photon.h.
#ifndef LANTHORN_EMC_PHOTON_GLSL
#define LANTHORN_EMC_PHOTON_GLSL

#include "engine/render/octahedral.glsl"

// A photon leaving a surface.
struct PhotonRay {
    vec3 origin;
    uint start;      // start_bits()
    vec4 direction;  // xyz unit; w = its density over 1 / pi (surface_bsdf.glsl), 0: lost
    vec3 power;      // rgb in lumen
    uint number;     // of its random numbers: depends on its light and its place among that light's photons alone
};

// A photon that has arrived: what is splatted.
struct PhotonHit {
    vec3 position;
    float radius;    // bandwidth h in metres; 0: no photon
    vec3 power;      // rgb in lumen
    uint normal;     // octahedral, 2 x snorm16
};

uint pack_normal(vec3 n) { return packSnorm2x16(octahedral_encode(n)); }
vec3 unpack_normal(uint n) { return octahedral_decode(unpackSnorm2x16(n)); }

// Where a photon starts: the map to ask first, 0..63, and its surface's normal, to a thousandth.
uint start_bits(int slot, vec3 n) {
    uvec2 e = uvec2(round((octahedral_encode(n) * 0.5 + 0.5) * 8191.0));
    return uint(slot) << 26u | e.x << 13u | e.y;
}
int first_map(uint start) { return int(start >> 26u); }
vec3 start_normal(uint start) { return octahedral_decode(vec2(start >> 13u & 8191u, start & 8191u) * (2.0 / 8191.0) - 1.0); }

#endif
