#version 450 core
// How many photons of each run touch each tile; then (FILL) their indices, at the places the prefix sums say. Lists keep the
// photons' order (no atomics), so sums are the same in every run.
// Every photon is tried on every tile, eight tiles an invocation: comparing with boxes in registers may be cheaper than
// finding out which boxes to fetch, as splat_project.comp does.
layout(local_size_x = 8, local_size_y = 8) in;

const int kTiles = 8;

uniform float least_radius;  // of photons, as they are sorted
uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform samplerBuffer tile_boxes;   // two texels a tile: lower, upper; lower > upper if empty
#define PHOTON_COUNT_BINDING 6
#include "gi_module/techniques/emc/photons/photon_count.glsl"
#include "splat_rects.glsl"
uniform usamplerBuffer photon_rects;
uniform ivec2 tile_grid;
layout(std430, binding = 3) buffer Counts { uint counts[]; };  // [tile][chunk]; for FILL: where the list goes on
#if FILL
layout(std430, binding = 4) writeonly buffer Lists { uint lists[]; };
uniform int list_capacity;
#endif
uniform int chunk_count;  // photons are cut into runs of chunk_size, a multiple of 32
uniform int chunk_size;
uniform int tile_count;

void main() {
    int first_tile = int(gl_GlobalInvocationID.x) * kTiles;
    int chunk = int(gl_GlobalInvocationID.y);
    if (first_tile >= tile_count || chunk >= chunk_count) return;
    vec3 lower[kTiles];
    vec3 upper[kTiles];
    uint count[kTiles];
    uint at[kTiles];
    for (int k = 0; k < kTiles; ++k) {
        int tile = first_tile + k;
        bool there = tile < tile_count;
        lower[k] = there ? texelFetch(tile_boxes, 2 * tile).xyz : vec3(1e30);
        upper[k] = there ? texelFetch(tile_boxes, 2 * tile + 1).xyz : vec3(-1e30);
        at[k] = pack_tile(ivec2(tile % tile_grid.x, tile / tile_grid.x));
        count[k] = 0u;
#if FILL
        count[k] = there ? counts[tile * chunk_count + chunk] : 0u;
#endif
    }
    int last = min((chunk + 1) * chunk_size, int(photon_set_count));
    for (int run = chunk * chunk_size; run < last; run += 32) {
        uint touched[kTiles];  // a bit a photon
        for (int k = 0; k < kTiles; ++k) touched[k] = 0u;
        for (int i = run; i < min(run + 32, last); ++i) {
            vec4 place = texelFetch(photon_hits, 2 * i);  // position, radius; 0: no photon
            float radius = place.w > 0.0 ? max(place.w, least_radius) : 0.0;
            float radius2 = radius * radius;
            uint bit = 1u << uint(i - run);
            uint rect = texelFetch(photon_rects, i).r;
            for (int k = 0; k < kTiles; ++k) {
                vec3 d = max(max(lower[k] - place.xyz, place.xyz - upper[k]), vec3(0.0));
                touched[k] |= lies_in(at[k], rect) && dot(d, d) < radius2 ? bit : 0u;
            }
        }
        for (int k = 0; k < kTiles; ++k) {
#if FILL
            while (touched[k] != 0u) {
                if (count[k] < uint(list_capacity)) lists[count[k]] = uint(run + findLSB(touched[k]));
                touched[k] &= touched[k] - 1u;
                ++count[k];
            }
#else
            count[k] += uint(bitCount(touched[k]));
#endif
        }
    }
#if !FILL
    for (int k = 0; k < kTiles; ++k) {
        if (first_tile + k < tile_count) counts[(first_tile + k) * chunk_count + chunk] = count[k];
    }
#endif
}
