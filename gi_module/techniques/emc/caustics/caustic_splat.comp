#version 450 core
// Irradiance by caustic photons. One work group sums 8 x 8 pixels: its invocations first find, each a share, the photons of
// their tile whose splats reach the block, then each sums those over four pixels. In order of photons, so that sums are the
// same in every run.
layout(local_size_x = 8) in;

#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"
#define BAD_VALUES_BINDING 4
#include "gi_module/shared/bad_values.glsl"
#include "gi_module/techniques/emc/splat/splat_tiles.glsl"
#include "caustic_kernel.glsl"

const int kLanes = 8;  // as many as a software rasteriser does together: what they all need of a photon is fetched once
const int kSide = 8;   // of the block
const int kPixels = 8;  // an invocation
const int kShare = 32;  // photons that an invocation tries on the block at once

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

shared vec3 lowers[kLanes];
shared vec3 uppers[kLanes];
shared int counts[kLanes];
shared int touching[kShare * kLanes];  // photons

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
        ivec2 p = corner + ivec2(lane % kSide, lane / kSide + k * (kLanes / kSide));
        ivec2 q = min(p, image_size - 1);
        float d = texelFetch(gbuffer_distance, q, 0).r;
        x[k] = render_position((vec2(q) + 0.5) / vec2(image_size), d);
        normal[k] = octahedral_decode(texelFetch(gbuffer_normals, q, 0).zw);
        there[k] = d > 0.0 && p == q;
        sum[k] = vec3(0.0);
        lower = there[k] ? min(lower, x[k]) : lower;
        upper = there[k] ? max(upper, x[k]) : upper;
    }
    lowers[lane] = lower;
    uppers[lane] = upper;
    barrier();
    for (int width = kLanes / 2; width > 0; width >>= 1) {
        if (lane < width) {
            lowers[lane] = min(lowers[lane], lowers[lane + width]);
            uppers[lane] = max(uppers[lane], uppers[lane + width]);
        }
        barrier();
    }
    lower = lowers[0];
    upper = uppers[0];

    for (int run = first; run < last; run += kShare * kLanes) {
        int begin = run + kShare * lane;
        uint mine = 0u;
        for (int i = 0; i < kShare; ++i) {
            vec4 place = texelFetch(photon_hits, 2 * photon_of(list, min(begin + i, last - 1)));
            vec3 d = max(max(lower - place.xyz, place.xyz - upper), vec3(0.0));
            mine |= begin + i < last && dot(d, d) < place.w * place.w ? 1u << uint(i) : 0u;
        }
        counts[lane] = bitCount(mine);
        barrier();
        int total = 0;
        int at = 0;
        for (int k = 0; k < kLanes; ++k) {
            at += k < lane ? counts[k] : 0;
            total += counts[k];
        }
        while (mine != 0u) {
            touching[at++] = photon_of(list, begin + findLSB(mine));
            mine &= mine - 1u;
        }
        barrier();
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
        ivec2 p = corner + ivec2(lane % kSide, lane / kSide + k * (kLanes / kSide));
        if (any(greaterThanEqual(p, image_size))) continue;
        vec3 e = first_entry > 0 ? imageLoad(caustics, p).rgb + sum[k] : sum[k];
        bool bad = is_bad(e);
        if (bad) atomicAdd(bad_value_count, 1u);
        imageStore(caustics, p, vec4(there[k] && !bad ? e : vec3(0.0), 0.0));
    }
}
