#version 450 core
// Irradiance by caustic photons. One work group sums 8 x 8 pixels: its invocations find the photons that reach the block, then
// each sums these over its pixels, in their order.
layout(local_size_x = 8) in;

#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"
#define BAD_VALUES_BINDING 4
#include "gi_module/shared/bad_values.glsl"
#include "caustic_kernel.glsl"

layout(rgba32f, binding = 0) uniform image2D caustics;
uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;
uniform ivec2 tile_grid;
uniform int tile_size;
uniform int first_entry;  // of each tile's list
uniform int entries;      // at most, of this dispatch
uniform float local_length;

float radius_of(vec4 place) { return place.w; }

#include "gi_module/techniques/emc/splat/block_photons.glsl"

void main() {
    int lane = int(gl_LocalInvocationID.x);
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * kSide;
    ivec2 tile_at = corner / tile_size;
    int tile = tile_at.y * tile_grid.x + tile_at.x;
    TileList list = list_of(tile);
    int first = list.first + first_entry;
    int last = min(first + entries, list.last);

    vec3 x[kPixels];
    vec3 normal[kPixels];
    vec3 sum[kPixels];
    bool there[kPixels];
    vec3 lower = vec3(1e30);
    vec3 upper = vec3(-1e30);
    for (int k = 0; k < kPixels; ++k) {
        ivec2 p = block_pixel(corner, lane, k);
        ivec2 q = min(p, image_size - 1);
        float d = texelFetch(gbuffer_distance, q, 0).r;
        x[k] = render_position((vec2(q) + 0.5) / vec2(image_size), d);
        normal[k] = octahedral_decode(texelFetch(gbuffer_normals, q, 0).zw);
        there[k] = d > 0.0 && p == q;
        sum[k] = vec3(0.0);
        lower = there[k] ? min(lower, x[k]) : lower;
        upper = there[k] ? max(upper, x[k]) : upper;
    }
    join_boxes(lane, lower, upper);

    for (int run = first; run < last; run += kShare * kLanes) {
        int total = find_touching(list, run, last, lane, lower, upper);
        for (int i = 0; i < total; ++i) {
            vec4 place = texelFetch(photon_hits, 2 * touching[i]);     // position, radius
            vec4 load = texelFetch(photon_hits, 2 * touching[i] + 1);  // power, normal
            vec3 photon_normal = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
            for (int k = 0; k < kPixels; ++k) {
                sum[k] += caustic_irradiance(place, load, photon_normal, x[k], normal[k], 1e-5 * local_length);
            }
        }
        barrier();
    }
    for (int k = 0; k < kPixels; ++k) {
        ivec2 p = block_pixel(corner, lane, k);
        if (any(greaterThanEqual(p, image_size))) continue;
        vec3 e = first_entry > 0 ? imageLoad(caustics, p).rgb + sum[k] : sum[k];
        bool bad = is_bad(e);
        if (bad) atomicAdd(bad_value_count, 1u);
        imageStore(caustics, p, vec4(there[k] && !bad ? e : vec3(0.0), 0.0));
    }
}
