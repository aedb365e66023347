#version 450 core
// Radiance that glossy surfaces reflect of the photons around each pixel, at full size (Yao et al. 2010, sec. 6 and Fig. 8): the splat of
// each, times the lobe for the direction in which it has come. One work group sums 8 x 8 pixels: its invocations find the photons that
// reach the block, then each sums these over its pixels, in their order.
layout(local_size_x = 8) in;

#define BANDWIDTH_FIXED 0
#include "splat_gather.glsl"
#include "engine/render/ggx.glsl"
#define BAD_VALUES_BINDING 4
#include "gi_module/shared/bad_values.glsl"

layout(rgba32f, binding = 0) uniform image2D glossy;  // a: share of the lobe
uniform usamplerBuffer photon_directions;  // PhotonSet::directions
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform ivec2 tile_grid;
uniform int tile_size;
uniform int first_entry;  // of each tile's list
uniform int entries;      // at most, of this dispatch
uniform float fixed_radius;  // metres; 0: each photon's own

struct Lobe {
    vec3 normal;
    vec3 towards;  // the viewer
    vec3 base;
    float metallic;
    float f0;
    float alpha;
};

// The specular part of engine/render/brdf.glsl, without the cosine: the splat has it.
vec3 reflected(Lobe s, vec3 l) {
    vec3 h = normalize(s.towards + l);
    float nl = dot(s.normal, l);
    float nv = max(dot(s.normal, s.towards), 1e-3);
    float nh = clamp(dot(s.normal, h), 0.0, 1.0);
    float rest = 1.0 - clamp(dot(s.towards, h), 0.0, 1.0);
    float fifth = rest * rest * rest * rest * rest;
    float a2 = s.alpha * s.alpha;
    float both = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
    vec3 fresnel = mix(vec3(s.f0 + (min(50.0 * s.f0, 1.0) - s.f0) * fifth), s.base + (1.0 - s.base) * fifth, s.metallic);
    return nl > 0.0 ? fresnel * (ggx_distribution(nh, s.alpha) * 0.5 / both) : vec3(0.0);
}

// `place`: position, radius; 0: no photon.
float radius_of(vec4 place) { return fixed_radius > 0.0 && place.w > 0.0 ? fixed_radius : place.w; }

#include "block_photons.glsl"

void main() {
    int lane = int(gl_LocalInvocationID.x);
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * kSide;
    ivec2 tile_at = corner / tile_size;
    TileList list = list_of(tile_at.y * tile_grid.x + tile_at.x);
    int first = list.first + first_entry;
    int last = min(first + entries, list.last);

    Receiver receiver[kPixels];
    Lobe lobe[kPixels];
    float scale[kPixels];  // 0: no lobe that photons light
    vec3 sum[kPixels];
    vec3 lower = vec3(1e30);
    vec3 upper = vec3(-1e30);
    for (int k = 0; k < kPixels; ++k) {
        ivec2 p = block_pixel(corner, lane, k);
        ivec2 q = min(p, image_size - 1);
        float d;
        receiver[k] = receiver_at(q, d);
        float share = p == q && d > 0.0 ? imageLoad(glossy, q).a : 0.0;
        vec4 albedo = texelFetch(gbuffer_albedo, q, 0);
        vec4 material = texelFetch(gbuffer_material, q, 0);
        lobe[k].normal = octahedral_decode(texelFetch(gbuffer_normals, q, 0).xy);
        lobe[k].towards = -pixel_direction((vec2(q) + 0.5) / vec2(image_size));
        lobe[k].base = albedo.rgb;
        lobe[k].metallic = albedo.a;
        lobe[k].f0 = material.g;
        lobe[k].alpha = max(material.r * material.r, 2e-3);
        scale[k] = share * material.b;
        sum[k] = vec3(0.0);
        lower = share > 0.0 ? min(lower, receiver[k].x) : lower;
        upper = share > 0.0 ? max(upper, receiver[k].x) : upper;
    }
    join_boxes(lane, lower, upper);
    last = lower.x > upper.x ? first : last;  // nothing glossy in the block

    for (int run = first; run < last; run += kShare * kLanes) {
        int total = find_touching(list, run, last, lane, lower, upper);
        for (int i = 0; i < total; ++i) {
            vec4 place = texelFetch(photon_hits, 2 * touching[i]);
            Photon photon = photon_with(place.xyz, texelFetch(photon_hits, 2 * touching[i] + 1), radius_of(place));
            vec3 l = -octahedral_decode(unpackSnorm2x16(texelFetch(photon_directions, touching[i]).r));
            for (int k = 0; k < kPixels; ++k) {
                if (scale[k] > 0.0) sum[k] += splat(receiver[k], photon) * reflected(lobe[k], l);
            }
        }
        barrier();
    }
    for (int k = 0; k < kPixels; ++k) {
        ivec2 p = block_pixel(corner, lane, k);
        if (any(greaterThanEqual(p, image_size)) || !(scale[k] > 0.0)) continue;
        vec4 before = imageLoad(glossy, p);
        vec3 radiance = before.rgb + max(sum[k], vec3(0.0)) * scale[k];
        bool bad = is_bad(radiance);
        if (bad) atomicAdd(bad_value_count, 1u);
        imageStore(glossy, p, vec4(bad ? vec3(0.0) : radiance, before.a));
    }
}
