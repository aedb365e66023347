#version 450 core
// Adds a run's photons to the pixels of a tile that show their surface and lie within h of them (Lavignotte and Paulin 2003,
// eq. 6): the sum of kernel times power in rgb, a photon's being copies of its group's; the number of photons in a. One work group a listed tile;
// each invocation has PIXELS of its 64 pixels, so that a photon is fetched once for all of them.
layout(local_size_x = LANES) in;

#define PIXELS (64 / LANES)

uniform usamplerBuffer photons;  // PhotonRecord
uniform usamplerBuffer entries;  // SplatEntry
uniform usamplerBuffer tiles;    // listed: tile, first and end of its entries
uniform usamplerBuffer pixels;   // PixelSurface
uniform samplerBuffer powers;    // by group of lights: what a copy carries, lumen
layout(rgba32f, binding = 0) uniform image2D sums;
uniform ivec2 image_size;
uniform int first_tile;
uniform int tiles_across;

void main() {
    uvec4 listed = texelFetch(tiles, first_tile + int(gl_WorkGroupID.x));
    int first = int(listed.y);
    int last = int(listed.z);
    ivec2 corner = 8 * ivec2(int(listed.x) % tiles_across, int(listed.x) / tiles_across);
    vec3 position[PIXELS];
    uint side[PIXELS];
    vec4 sum[PIXELS];
    for (int k = 0; k < PIXELS; ++k) {
        int i = int(gl_LocalInvocationID.x) + k * LANES;
        ivec2 pixel = min(corner + ivec2(i & 7, i >> 3), image_size - 1);
        uvec4 at = texelFetch(pixels, pixel.y * image_size.x + pixel.x);
        position[k] = uintBitsToFloat(at.xyz);
        side[k] = at.w;
        sum[k] = vec4(0.0);
    }
    for (int e = first; e < last; ++e) {
        uvec4 entry = texelFetch(entries, 2 * e);
        vec4 tile_place = uintBitsToFloat(texelFetch(entries, 2 * e + 1));
        float square = uintBitsToFloat(entry.w);
        float inverse = 1.0 / square;
        float reach[PIXELS];
        for (int k = 0; k < PIXELS; ++k) reach[k] = side[k] == entry.z ? square : -1.0;
        int end = int(entry.x + (entry.y & 0xffffu));
        vec3 power = texelFetch(powers, int(entry.y >> 16)).rgb;
        for (int run = int(entry.x); run < end; run += 32) {
            // Those that reach the tile first: one test is less than those of its pixels.
            uint near = 0u;
            for (int i = 0; i < 32 && run + i < end; ++i) {
                vec3 d = uintBitsToFloat(texelFetch(photons, run + i).xyz) - tile_place.xyz;
                near |= dot(d, d) < tile_place.w ? 1u << uint(i) : 0u;
            }
            while (near != 0u) {
                uvec4 photon = texelFetch(photons, run + findLSB(near));
                near &= near - 1u;
                vec3 place = uintBitsToFloat(photon.xyz);
                vec3 copies = vec3(float(photon.w & 7u), float(photon.w >> 3 & 7u), float(photon.w >> 6 & 7u));
                vec4 load = vec4(copies * power, (photon.w >> 9 & 1u) == 0u ? 1.0 : 0.0);  // not more(): one more photon
                for (int k = 0; k < PIXELS; ++k) {
                    vec3 d = place - position[k];
                    float distance = dot(d, d);
#if EPANECHNIKOV
                    float weight = distance < reach[k] ? 1.0 - distance * inverse : 0.0;
                    sum[k] += vec4(load.rgb * weight, distance < reach[k] ? load.a : 0.0);
#else
                    sum[k] += distance < reach[k] ? load : vec4(0.0);
#endif
                }
            }
        }
    }
    for (int k = 0; k < PIXELS; ++k) {
        int i = int(gl_LocalInvocationID.x) + k * LANES;
        ivec2 pixel = corner + ivec2(i & 7, i >> 3);
        if (any(greaterThanEqual(pixel, image_size))) continue;
        imageStore(sums, pixel, imageLoad(sums, pixel) + sum[k]);
    }
}
