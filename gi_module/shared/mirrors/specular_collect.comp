#version 450 core
// What the rays of specular.glsl have brought, of all their ends: what those reflect (specular_shade.glsl) and what they emit.
layout(local_size_x = 64) in;

#include "engine/render/shining_lights.glsl"
#include "engine/render/traced_lobes.glsl"
#include "engine/gpu/work_items.glsl"
#include "specular.glsl"
#define BAD_VALUES_BINDING 7
#include "gi_module/shared/bad_values.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) readonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 3) readonly buffer Hits { SpecularHit hits[]; };
layout(std430, binding = 4) readonly buffer Reflected { vec4 reflected[]; };
layout(std430, binding = 5) buffer Samples { SpecularSample samples[]; };

// The share of a met light's emission that the ray brings; direct light brings the rest, if it has samples of that light. Of a small
// light over mirrors and through glass the rest is missing: one ray in thousands would meet it, and sparkle.
float share_of_emission(SpecularRay ray, SpecularHit hit, float density) {
    float share = 1.0;
#ifdef WITH_AREA
    float nearest = 3e38;
    int at = punctual_end;
    for (int k = punctual_end; k < light_end; ++k) {
        vec3 off = lights[k].position - hit.position;
        bool may_be = hit.emitter == 0u || lights[k].id + 1u == hit.emitter;
        bool nearer = may_be && dot(off, off) < nearest;
        at = nearer ? k : at;
        nearest = nearer ? dot(off, off) : nearest;
    }
    // Where it is not known what was met: a lamp that has a sample nearby.
    bool sampled = hit.emitter != 0u ? nearest < 3e38 : nearest < 16.0 * lights[at].area;
    if (sampled) share = share_of_rays(density, area_solid_angle(lights[at], ray.origin));
#endif
    return share;
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    uint at = 2u * rays[i].pixel + (rays[i].through & 1u);
    float density = samples[at].density;
    vec3 radiance = vec3(0.0), lobe = vec3(0.0);
    float known = 0.0;
    uint end = i;
    do {  // no next is 0
        SpecularHit hit = hits[end];
        vec3 here = hit.emission;
        if (density > 0.0 && hit.emission != vec3(0.0)) here *= share_of_emission(rays[i], hit, density);
        here += reflected[end].rgb;
        bool spread = density < 0.0 && hit.spread > 0.0;
        radiance += spread ? vec3(0.0) : here;
        lobe += spread ? here : vec3(0.0);
        known = max(known, hit.kind == kNothingKnown ? 0.0 : hit.spread > 0.0 ? kSpread : 1.0);
        end = hit.next;
    } while (end != 0u);
    if (is_bad(radiance + lobe)) {
        atomicAdd(bad_value_count, 1u);
        radiance = lobe = vec3(0.0);
    }
    samples[at].radiance = radiance;
    if (density < 0.0) samples[at].lobe = lobe;
    samples[at].known = known;
}
