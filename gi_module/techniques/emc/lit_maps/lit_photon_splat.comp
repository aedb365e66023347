#version 450 core
// Photons that have arrived are counted by the coarse texel of the lit texel that shows where.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_lookup.glsl"

layout(std430, binding = 5) buffer Sums { uint sums[]; };  // by place of the coarse texel: rgb, two words each
#include "fixed_sums.glsl"
#define PHOTON_COUNT_BINDING 6
#include "gi_module/techniques/emc/photons/photon_count.glsl"

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform usamplerBuffer homes;       // by place: that of the coarse texel + 1
uniform samplerBuffer rest;         // one: what the photons of the last bounce stand for
uniform vec3 units;                 // a lumen
uniform int photons;                // of all bounces, and those at first surfaces
uniform int last_bounce;            // its first photon
uniform int first_arrival;          // at a first surface

void main() {
    int i = int(work_item());
    if (i >= min(photons, int(photon_set_count))) return;
    vec4 hit = texelFetch(photon_hits, 2 * i);  // position, bandwidth: 0 for none
    if (hit.w <= 0.0) return;
    vec4 load = texelFetch(photon_hits, 2 * i + 1);  // power, normal
    vec3 n = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
    uint found = shown_place_of(hit.xyz, -n, n);
    uint home = found < kListed ? texelFetch(homes, int(found)).r : 0u;
    if (home == 0u) return;
    vec3 power = load.rgb * units * (i < last_bounce || i >= first_arrival ? vec3(1.0) : texelFetch(rest, 0).rgb);
    for (int c = 0; c < 3; ++c) {
        if (power[c] >= 1.0) add_units(3u * (home - 1u) + uint(c), power[c]);
    }
}
