#version 450 core
// The light that comes back along the rays of emc/specular.glsl: emitted, and reflected of direct light, by the light maps, and of
// indirect light, by the direct radiance maps; or the sky's.
layout(local_size_x = 64) in;

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/ggx.glsl"
#include "engine/render/sky.glsl"
#include "engine/render/traced_lobes.glsl"
#include "gi_module/emc/point_lists.glsl"
#include "gi_module/emc/specular.glsl"
#include "drm_gather.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/emc/bad_values.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) readonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 3) readonly buffer Hits { SpecularHit hits[]; };
layout(std430, binding = 6) buffer Brought { SpecularSample brought[]; };

uniform int has_sky;
uniform int has_indirect;

// The share of a met lamp's emission that the ray brings; direct light brings the rest, if it has samples of that lamp.
float share_of_emission(SpecularRay ray, SpecularHit hit, float density) {
    float share = 1.0;
#ifdef WITH_AREA
    float nearest = 3e38;
    int at = punctual_count;
    for (int k = punctual_count; k < light_count; ++k) {
        vec3 off = lights[k].position - hit.position;
        bool nearer = lights[k].id + 1u == hit.emitter && dot(off, off) < nearest;
        at = nearer ? k : at;
        nearest = nearer ? dot(off, off) : nearest;
    }
    if (nearest < 3e38) share = share_of_rays(density, area_solid_angle(lights[at], ray.origin));
#endif
    return share;
}

vec3 radiance_of(SpecularHit hit, SpecularRay ray, float density) {
    vec3 radiance = hit.emission;
    if (density > 0.0 && hit.emission != vec3(0.0)) radiance *= share_of_emission(ray, hit, density);
    if (hit.kind == kMetSky && has_sky != 0) radiance = hit.reflectance * sky_radiance(hit.normal);
    if (hit.kind == kMetSurface) {
        vec3 e = direct_irradiance(hit.position, hit.normal);
        if (has_indirect != 0) e += gathered_irradiance(hit.position, hit.normal);
        radiance += hit.reflectance * e * 0.31830988618;
    }
    return radiance;
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    uint at = 2u * rays[i].pixel + (rays[i].through & 1u);
    float density = brought[at].density;
    vec3 radiance = vec3(0.0), lobe = vec3(0.0);
    float known = 0.0;
    uint end = i;
    do {  // all ends of the ray: no next is 0
        SpecularHit hit = hits[end];
        vec3 here = radiance_of(hit, rays[i], density);
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
    brought[at].radiance = radiance;
    if (density < 0.0) brought[at].lobe = lobe;
    brought[at].known = known;
}
