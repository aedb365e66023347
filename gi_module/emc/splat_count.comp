#version 450 core
// How many photons of each run touch each tile; then (FILL) their indices, at the places the prefix sums say.
layout(local_size_x = 32) in;

#include "splat_tiles.glsl"

layout(std430, binding = 3) buffer Counts { uint counts[]; };  // [tile][chunk]; for FILL: where the next index goes
#if FILL
layout(std430, binding = 4) writeonly buffer Lists { uint lists[]; };
#endif

void main() {
    int chunk = int(gl_GlobalInvocationID.x);
    if (chunk >= chunk_count) return;
    int last = min((chunk + 1) * chunk_size, hit_count);
    for (int i = chunk * chunk_size; i < last; ++i) {
        vec4 place = texelFetch(photon_hits, 2 * i);
        vec3 centre = place.xyz;
        float radius = place.w;
        ivec4 range = radius > 0.0 ? tile_range(centre, radius) : ivec4(0);
        for (int y = range.y; y < range.w; ++y) {
            for (int x = range.x; x < range.z; ++x) {
                int tile = y * tile_grid.x + x;
                if (touches(tile, centre, radius)) {
                    int slot = tile * chunk_count + chunk;
#if FILL
                    uint place = counts[slot];
                    lists[place] = uint(i);
                    counts[slot] = place + 1u;
#else
                    counts[slot] += 1u;
#endif
                }
            }
        }
    }
}
