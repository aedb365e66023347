#version 450 core
// Prefix sums over counts[tile][chunk]: one invocation a tile, then one for all tiles (STAGE 1), then added back (STAGE 2).
layout(local_size_x = 32) in;

#define TILE_LISTS_ACCESS
#define PHOTON_COUNT_BINDING 6
#include "gi_module/techniques/emc/photons/photon_count.glsl"
#include "splat_tiles.glsl"

layout(std430, binding = 3) buffer Counts { uint counts[]; };
uniform int chunk_count;
uniform int tile_count;

void main() {
    int tile = int(gl_GlobalInvocationID.x);
#if STAGE == 0
    if (tile >= tile_count) return;
    uint sum = 0u;
    for (int i = tile * chunk_count; i < (tile + 1) * chunk_count; ++i) {
        uint n = counts[i];
        counts[i] = sum;
        sum += n;
    }
    starts[tile] = sum;
#elif STAGE == 1
    if (tile != 0) return;
    uint sum = 0u;
    uint longest = 0u;
    for (int i = 0; i < tile_count; ++i) {
        uint n = starts[i];
        starts[i] = sum;
        sum += n;
        longest = max(longest, sum > uint(list_capacity) ? photon_set_count : n);
    }
    starts[tile_count] = sum;
    list_entries = sum;
    list_photons = photon_set_count;
    longest_list = longest;
#else
    if (tile >= tile_count) return;
    uint start = starts[tile];
    for (int i = tile * chunk_count; i < (tile + 1) * chunk_count; ++i) {
        counts[i] += start;
    }
#endif
}
