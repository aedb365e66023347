// Direct light of all light sources at one point of a surface.
#ifndef LANTHORN_DIRECT_GLSL
#define LANTHORN_DIRECT_GLSL
#include "brdf.glsl"
#include "ggx.glsl"
#include "shadow.glsl"
#include "traced_lobes.glsl"

uniform int light_count;
uniform int punctual_count;

// Radiance towards unit `v`, nits. `point` in render space; `shading` and `geometric` unit, on the side of `v`.
// WITH_PUNCTUAL and WITH_AREA: which kinds of light there are, at least one of each that is defined. The loops test at
// their end and have no `continue`: a software rasteriser runs a loop's body once more for a test at its start, and
// both sides of every `if`.
// `traced`: share of the specular lobe that rays follow, which bring area lights, too (share_of_rays()).
vec3 direct_radiance(vec3 point, vec3 v, vec3 shading, vec3 geometric, vec3 base, float metallic, float roughness,
                     float f0, float traced) {
    vec3 sum = vec3(0.0);
    vec3 l;
    float distance;
#ifdef WITH_PUNCTUAL
    int i = 0;
    do {
        vec3 illuminance = punctual_illuminance(lights[i], point, l, distance);
        float cosine = dot(geometric, l) > 0.0 ? max(dot(shading, l), 0.0) : 0.0;
        float weight = cosine * punctual_visibility(lights[i], point, geometric, l, distance);
        vec3 brdf = metallic_roughness_brdf(base, metallic, roughness, f0, shading, v, l, 1.0);
        if (weight > 0.0) sum += illuminance * brdf * weight;
    } while (++i < punctual_count);
#endif
#ifdef WITH_AREA
    float a = max(roughness * roughness, 2e-3);
    int k = punctual_count;
    do {
        vec3 illuminance = area_illuminance(lights[k], point, l, distance);
        float cosine = dot(geometric, l) > 0.0 ? max(dot(shading, l), 0.0) : 0.0;
        float weight = cosine * area_visibility(lights[k], point, geometric, l, distance);
        float by_rays = share_of_rays(lobe_density(shading, v, l, a), area_solid_angle(lights[k], point));
        vec3 brdf = metallic_roughness_brdf(base, metallic, roughness, f0, shading, v, l, 1.0 - traced * by_rays);
        if (weight > 0.0) sum += illuminance * brdf * weight;
    } while (++k < light_count);
#endif
    return sum;
}

#endif
