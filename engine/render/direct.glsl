// Direct light of all light sources at one point of a surface.
#ifndef LANTHORN_DIRECT_GLSL
#define LANTHORN_DIRECT_GLSL
#include "brdf.glsl"
#include "shadow.glsl"

uniform int light_count;

// Radiance towards unit `v`, nits. `point` in render space; `shading` and `geometric` unit, on the side of `v`.
vec3 direct_radiance(vec3 point, vec3 v, vec3 shading, vec3 geometric, vec3 base, float metallic, float roughness,
                     float f0) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count; ++i) {
        LightData light = lights[i];
        vec3 l;
        float distance;
        vec3 illuminance = light_illuminance(light, point, l, distance);
        float cosine = dot(shading, l);
        if (cosine <= 0.0 || dot(geometric, l) <= 0.0 || illuminance == vec3(0.0)) continue;
        float visible = light_visibility(light, point, geometric, l, distance);
        if (visible <= 0.0) continue;
        sum += illuminance * metallic_roughness_brdf(base, metallic, roughness, f0, shading, v, l) * (cosine * visible);
    }
    return sum;
}

#endif
