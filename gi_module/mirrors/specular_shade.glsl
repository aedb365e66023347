// The light that comes back along the rays of specular.glsl: emitted, and reflected of direct light, by the light maps, and of
// indirect light, by the technique that includes this; or the sky's. It has defined before
//   vec3 indirect_irradiance(uint end, SpecularHit hit)
// lux on the surface that was met there, `end` being the hit's number.
#ifndef LANTHORN_MIRRORS_SPECULAR_SHADE_GLSL
#define LANTHORN_MIRRORS_SPECULAR_SHADE_GLSL

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/ggx.glsl"
#include "engine/render/sky.glsl"
#include "engine/render/traced_lobes.glsl"
#include "gi_module/work_items.glsl"
#include "specular.glsl"
#define BAD_VALUES_BINDING 7
#include "gi_module/bad_values.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) readonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 3) readonly buffer Hits { SpecularHit hits[]; };
layout(std430, binding = 5) buffer Samples { SpecularSample samples[]; };

uniform int has_sky;

// The share of a met light's emission that the ray brings; direct light brings the rest, if it has samples of that light. Of a small
// light over mirrors and through glass the rest is missing: one ray in thousands would meet it, and sparkle.
float share_of_emission(SpecularRay ray, SpecularHit hit, float density) {
    float share = 1.0;
#ifdef WITH_AREA
    float nearest = 3e38;
    int at = punctual_count;
    for (int k = punctual_count; k < light_count; ++k) {
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

vec3 radiance_of(uint end, SpecularHit hit, SpecularRay ray, float density) {
    vec3 radiance = hit.emission;
    if (density > 0.0 && hit.emission != vec3(0.0)) radiance *= share_of_emission(ray, hit, density);
    if (hit.kind == kMetSky && has_sky != 0) radiance = hit.reflectance * sky_radiance(hit.normal);
    if (hit.kind == kMetSurface) {
        vec3 e = direct_irradiance(hit.position, hit.normal);
        e += indirect_irradiance(end, hit);
        radiance += hit.reflectance * e * 0.31830988618;
    }
    return radiance;
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    uint at = 2u * rays[i].pixel + (rays[i].through & 1u);
    float density = samples[at].density;
    vec3 radiance = vec3(0.0), lobe = vec3(0.0);
    float known = 0.0;
    uint end = i;
    do {  // all ends of the ray: no next is 0
        SpecularHit hit = hits[end];
        vec3 here = radiance_of(end, hit, rays[i], density);
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

#endif
