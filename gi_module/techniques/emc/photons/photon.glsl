// Photons as the passes hand them on. The C++ side: photon.h.
#ifndef LANTHORN_EMC_PHOTON_GLSL
#define LANTHORN_EMC_PHOTON_GLSL

#include "engine/render/octahedral.glsl"

// A photon leaving a surface.
struct PhotonRay {
    vec4 origin;     // xyz; w = slot of the map to ask first, -1 if unknown
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

#endif
