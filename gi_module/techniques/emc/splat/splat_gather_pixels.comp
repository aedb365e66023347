#version 450 core
// Irradiance of a whole level (LISTED 0) or of the pixels that up-sampling has listed (LISTED 1), as splat_gather.comp sums it,
// with an invocation a pixel. A work group's 64 pixels are of one tile. Its invocations look at 64 photons of the tile's
// list at a time, put those that reach the box around the pixels' points into shared memory, and each sums them in order.
layout(local_size_x = 64) in;

#include "splat_gather.glsl"
#define BATCH 64u
#include "splat_lists.glsl"
#define BAD_VALUES_BINDING 4
#include "gi_module/shared/bad_values.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;
#if LISTED
layout(std430, binding = 2) readonly buffer Listed { uint listed[]; };      // by tile
layout(std430, binding = 3) readonly buffer TileCounts { uint tile_counts[]; };
layout(std430, binding = 7) readonly buffer Batches { uint batches[]; };
#endif
uniform ivec2 tile_grid;
uniform int tile_size;
uniform ivec2 level_size;

const int kPixels = 64;
shared vec3 lowers[kPixels];
shared vec3 uppers[kPixels];
shared uint touched[kPixels / 32];  // a bit a photon
// Photons, in vectors: that takes the least room.
shared vec4 position_inverse_h2[kPixels];
shared vec4 power_thickness[kPixels];
shared vec4 nodes[kPixels];
shared vec3 normals[kPixels];

void put(uint place, Photon photon) {
    position_inverse_h2[place] = vec4(photon.position, photon.inverse_h2);
    power_thickness[place] = vec4(photon.power, photon.thickness);
    nodes[place] = photon.node_weights;
    normals[place] = photon.normal;
}

Photon taken(int place) {
    vec4 at = position_inverse_h2[place];
    vec4 load = power_thickness[place];
    return Photon(at.xyz, normals[place], load.rgb, at.w, nodes[place], load.w);
}

void main() {
    int lane = int(gl_LocalInvocationID.x);
    int side = tile_size / stride;  // of a tile in this level's pixels
#if LISTED
    uint batch = min(row_index(gl_WorkGroupID), batch_count - 1u);  // surplus groups do the last one again
    uint entry = batches[batch];
    int tile = int(entry >> 10u);
    uint word = listed[tile * side * side + min(int((entry & 1023u) * kBatch) + lane, int(tile_counts[tile]) - 1)];
    ivec2 p = ivec2(int(word & 0xffffu), int(word >> 16u));
#else
    int tile = int(gl_WorkGroupID.x);
    int block = int(gl_WorkGroupID.y);  // of 8 x 8 pixels
    int blocks = max(side / 8, 1);
    ivec2 at = ivec2(block % blocks, block / blocks) * 8 + ivec2(lane % 8, lane / 8);
    ivec2 p = ivec2(tile % tile_grid.x, tile / tile_grid.x) * side + min(at, ivec2(side - 1));
    p = min(p, level_size - 1);
#endif
    float d;
    Receiver r = receiver_at(full_size_pixel(p), d);
    lowers[lane] = d > 0.0 ? r.x : vec3(1e30);
    uppers[lane] = d > 0.0 ? r.x : vec3(-1e30);
    barrier();
    for (int width = kPixels / 2; width > 0; width >>= 1) {
        if (lane < width) {
            lowers[lane] = min(lowers[lane], lowers[lane + width]);
            uppers[lane] = max(uppers[lane], uppers[lane + width]);
        }
        barrier();
    }
    vec3 lower = lowers[0];
    vec3 upper = uppers[0];
    TileList list = list_of(tile);
    vec3 sum = vec3(0.0);
    for (int run = list.first; run < list.last; run += kPixels) {
        if (lane < kPixels / 32) touched[lane] = 0u;
        barrier();
        int photon = run + lane < list.last ? photon_of(list, run + lane) : -1;
        vec4 place = texelFetch(photon_hits, 2 * max(photon, 0));
        vec3 apart = max(max(lower - place.xyz, place.xyz - upper), vec3(0.0));
        bool reaches = photon >= 0 && dot(apart, apart) < place.w * place.w;
        if (reaches) atomicOr(touched[lane >> 5], 1u << uint(lane & 31));
        barrier();
        uint low = touched[0];
        uint high = touched[1];
        uint before = lane < 32 ? uint(bitCount(low & ((1u << uint(lane)) - 1u)))
                                : uint(bitCount(low) + bitCount(high & ((1u << uint(lane - 32)) - 1u)));
        if (reaches) put(before, photon_at(photon));
        barrier();
        int count = bitCount(low) + bitCount(high);
        for (int k = 0; k < count; ++k) sum += splat(r, taken(k));
        barrier();
    }
    bool bad = is_bad(sum);
    if (bad) atomicAdd(bad_value_count, 1u);
    imageStore(irradiance, p, vec4(d > 0.0 && !bad ? max(sum, vec3(0.0)) : vec3(0.0), 0.0));
}
