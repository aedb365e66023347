#version 450 core
// How many photons of each run touch each tile; then (FILL) their indices, as splat_count.comp finds them, bit for bit. Here each
// photon is tried on the tiles of its rectangle alone. One work group a run: its invocations take a photon each, mark it in
// the tiles that it touches, and then count the marks of a tile each.
layout(local_size_x = 32) in;

#define PHOTON_COUNT_BINDING 6
#include "gi_module/techniques/emc/photons/photon_count.glsl"
#include "splat_rects.glsl"

const int kTilesAtOnce = 1024;

uniform float least_radius;  // of photons, as they are sorted
uniform samplerBuffer photon_hits;   // PhotonHit, two texels each
uniform samplerBuffer tile_boxes;    // two texels a tile: lower, upper; lower > upper if empty
uniform usamplerBuffer photon_rects;
layout(std430, binding = 3) buffer Counts { uint counts[]; };  // [tile][chunk]; for FILL: where the list goes on
#if FILL
layout(std430, binding = 4) writeonly buffer Lists { uint lists[]; };
uniform int list_capacity;
#endif
uniform ivec2 tile_grid;
uniform int chunk_count;  // photons are cut into runs of chunk_size, a multiple of 32
uniform int chunk_size;
uniform int tile_count;

shared uint touched[kTilesAtOnce];  // a bit a photon
shared uint count[kTilesAtOnce];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    int chunk = int(gl_WorkGroupID.x);
    int last = min((chunk + 1) * chunk_size, int(photon_set_count));
    for (int first_tile = 0; first_tile < tile_count; first_tile += kTilesAtOnce) {
        int tiles = min(tile_count - first_tile, kTilesAtOnce);
        for (int t = lane; t < tiles; t += 32) {
            touched[t] = 0u;
            count[t] = 0u;
#if FILL
            count[t] = counts[(first_tile + t) * chunk_count + chunk];
#endif
        }
        barrier();
        for (int run = chunk * chunk_size; run < last; run += 32) {
            int i = run + lane;
            ivec4 rect = unpack_rect(i < last ? texelFetch(photon_rects, i).r : kNoTiles);
            vec4 place = texelFetch(photon_hits, 2 * min(i, last - 1));
            float radius = place.w > 0.0 ? max(place.w, least_radius) : 0.0;
            int wide = rect.z - rect.x + 1;
            int tried = max(wide, 0) * max(rect.w - rect.y + 1, 0);
            int tile = rect.y * tile_grid.x + rect.x;
            int left = wide;  // of a row
            for (int k = 0; k < tried; ++k) {
                vec3 lower = texelFetch(tile_boxes, 2 * tile).xyz;
                vec3 upper = texelFetch(tile_boxes, 2 * tile + 1).xyz;
                vec3 d = max(max(lower - place.xyz, place.xyz - upper), vec3(0.0));
                int t = tile - first_tile;
                if (dot(d, d) < radius * radius && t >= 0 && t < tiles) atomicOr(touched[t], 1u << uint(lane));
                --left;
                tile += left > 0 ? 1 : tile_grid.x - wide + 1;
                left = left > 0 ? left : wide;
            }
            barrier();
            for (int t = lane; t < tiles; t += 32) {
                uint marks = touched[t];
                touched[t] = 0u;
#if FILL
                while (marks != 0u) {
                    if (count[t] < uint(list_capacity)) lists[count[t]] = uint(run + findLSB(marks));
                    marks &= marks - 1u;
                    ++count[t];
                }
#else
                count[t] += uint(bitCount(marks));
#endif
            }
            barrier();
        }
#if !FILL
        for (int t = lane; t < tiles; t += 32) counts[(first_tile + t) * chunk_count + chunk] = count[t];
#endif
    }
}
