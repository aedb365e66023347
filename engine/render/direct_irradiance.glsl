// Direct light that falls on a point, of all light sources.
#ifndef LANTHORN_DIRECT_IRRADIANCE_GLSL
#define LANTHORN_DIRECT_IRRADIANCE_GLSL
#include "shadow.glsl"
#include "shining_lights.glsl"

vec3 punctual_irradiance(LightData light, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    vec3 illuminance = punctual_illuminance(light, point, l, distance);
    float weight = dot(normal, l) * punctual_visibility(light, point, normal, l, distance);
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

vec3 area_irradiance(LightData light, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    vec3 illuminance = area_illuminance(light, point, l, distance);
    float weight = dot(normal, l) * area_visibility(light, point, normal, l, distance);
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

// Illuminance on a surface of unit `normal` at `point`, rgb in lux.
vec3 direct_irradiance(vec3 point, vec3 normal) {
    vec3 sum = vec3(0.0);
#define ADD_PUNCTUAL(LIGHT) sum += punctual_irradiance(LIGHT, point, normal);
#define ADD_AREA(LIGHT) sum += area_irradiance(LIGHT, point, normal);
    PUNCTUAL_LIGHTS(ADD_PUNCTUAL)
    AREA_LIGHTS(ADD_AREA)
    return sum;
}

#endif
