#version 450 core
// Irradiance of a whole level (LISTED 0) or of the pixels that up-sampling has listed (LISTED 1). One work group sums kBatch
// pixels of one tile: its invocations share the tile's photons out, so that each photon is fetched once for all pixels.
layout(local_size_x = LANES) in;

#include "splat_gather.glsl"
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
uniform int long_list;  // entries: more are for the program that has many lanes

const int kLanes = int(gl_WorkGroupSize.x);
const int kSums = int(kBatch) * 3;
shared float partial[kSums * kLanes];
shared float total[kSums];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    int side = tile_size / stride;  // of a tile in this level's pixels
#if LISTED
    uint batch = min(row_index(gl_WorkGroupID), batch_count - 1u);  // surplus groups do the last one again
    uint entry = batches[batch];
    int tile = int(entry >> 10u);
    int first = int((entry & 1023u) * kBatch);
    int last_pixel = int(tile_counts[tile]) - 1;
#else
    int tile = int(gl_WorkGroupID.x);
    int first = int(gl_WorkGroupID.y * kBatch);
    int last_pixel = side * side - 1;
#endif
    TileList list = list_of(tile);
    if ((list.last - list.first > long_list) != (MANY_LANES != 0)) return;
    ivec2 tile_origin = ivec2(tile % tile_grid.x, tile / tile_grid.x) * side;
    ivec2 p[kBatch];
    float d[kBatch];
    Receiver r[kBatch];
    for (int k = 0; k < int(kBatch); ++k) {
        int i = min(first + k, last_pixel);
#if LISTED
        uint word = listed[tile * side * side + i];
        p[k] = ivec2(int(word & 0xffffu), int(word >> 16u));
#else
        p[k] = min(tile_origin + ivec2(i % side, i / side), level_size - 1);
#endif
        r[k] = receiver_at(full_size_pixel(p[k]), d[k]);
    }
    vec3 lower = r[0].x;
    vec3 upper = r[0].x;
    for (int k = 1; k < int(kBatch); ++k) {
        lower = min(lower, r[k].x);
        upper = max(upper, r[k].x);
    }
    vec3 sum[kBatch];
    for (int k = 0; k < int(kBatch); ++k) sum[k] = vec3(0.0);
    int last = list.last;
    // Photons whose splats reach the box around the batch's points are found first, 32 a lane at a time: most of a tile's photons
    // are far from any one batch, and one box is tried for less than eight splats are summed.
    for (int run = list.first + lane; run < last; run += 32 * kLanes) {
        uint touched = 0u;
        for (int i = 0; i < 32 && run + i * kLanes < last; ++i) {
            vec4 place = texelFetch(photon_hits, 2 * photon_of(list, run + i * kLanes));
            vec3 d = max(max(lower - place.xyz, place.xyz - upper), vec3(0.0));
            touched |= dot(d, d) < place.w * place.w ? 1u << uint(i) : 0u;
        }
        while (touched != 0u) {
            Photon photon = photon_at(photon_of(list, run + findLSB(touched) * kLanes));
            touched &= touched - 1u;
            for (int k = 0; k < int(kBatch); ++k) sum[k] += splat(r[k], photon);
        }
    }
    for (int k = 0; k < int(kBatch); ++k) {
        partial[(3 * k + 0) * kLanes + lane] = sum[k].x;
        partial[(3 * k + 1) * kLanes + lane] = sum[k].y;
        partial[(3 * k + 2) * kLanes + lane] = sum[k].z;
    }
    barrier();
    for (int s = lane; s < kSums; s += kLanes) {
        float all = 0.0;
        for (int k = 0; k < kLanes; ++k) all += partial[s * kLanes + k];
        total[s] = all;
    }
    barrier();
    if (lane == 0) {
        for (int k = 0; k < int(kBatch); ++k) {
            vec3 e = vec3(total[3 * k], total[3 * k + 1], total[3 * k + 2]);
            bool bad = is_bad(e);
            if (bad) atomicAdd(bad_value_count, 1u);
            imageStore(irradiance, p[k], vec4(d[k] > 0.0 && !bad ? max(e, vec3(0.0)) : vec3(0.0), 0.0));
        }
    }
}
