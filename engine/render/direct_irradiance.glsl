// Direct light that falls on a point, of all light sources.
#ifndef LANTHORN_DIRECT_IRRADIANCE_GLSL
#define LANTHORN_DIRECT_IRRADIANCE_GLSL
#include "shadow.glsl"

uniform int light_count;
uniform int punctual_count;

// Illuminance on a surface of unit `normal` at `point`, rgb in lux.
vec3 direct_irradiance(vec3 point, vec3 normal) {
    vec3 sum = vec3(0.0);
    vec3 l;
    float distance;
#ifdef WITH_PUNCTUAL
    for (int i = 0; i < punctual_count; ++i) {
        vec3 illuminance = punctual_illuminance(lights[i], point, l, distance);
        float cosine = dot(normal, l);
        if (cosine > 0.0) sum += illuminance * (cosine * punctual_visibility(lights[i], point, normal, l, distance));
    }
#endif
#ifdef WITH_AREA
    for (int i = punctual_count; i < light_count; ++i) {
        vec3 illuminance = area_illuminance(lights[i], point, l, distance);
        float cosine = dot(normal, l);
        if (cosine > 0.0) sum += illuminance * (cosine * area_visibility(lights[i], point, normal, l, distance));
    }
#endif
    return sum;
}

#endif
