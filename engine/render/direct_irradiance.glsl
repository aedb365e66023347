// Direct light that falls on a point, of all light sources.
#ifndef LANTHORN_DIRECT_IRRADIANCE_GLSL
#define LANTHORN_DIRECT_IRRADIANCE_GLSL
#include "near_emitters.glsl"
#include "shadow.glsl"
#include "shining_lights.glsl"

// Of one light, by its kind.
vec3 punctual_irradiance(LightData light, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    vec3 illuminance = punctual_illuminance(light, point, l, distance);
    float weight = dot(normal, l) * punctual_visibility(light, point, normal, l, distance);
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

// As far as it is not near.
vec3 area_irradiance(LightData light, float nearness, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    vec3 illuminance = area_illuminance(light, point, l, distance);
    float weight = (1.0 - nearness) * dot(normal, l) * area_visibility(light, point, normal, l, distance);
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

// As far as it is near.
vec3 near_irradiance(LightData light, float nearness, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    area_illuminance(light, point, l, distance);
    float weight = nearness * area_visibility(light, point, normal, l, distance);
    vec3 irradiance = near_light(light, nearness, point, normal, normal).irradiance;
    return weight > 0.0 ? irradiance * weight : vec3(0.0);
}

// Of all area samples.
vec3 area_irradiances(vec3 point, vec3 normal) {
    vec3 sum = vec3(0.0);
#ifdef WITH_AREA
    int near = light_end;
#define ADD_AREA(LIGHT)                                            \
    {                                                              \
        LightData light = LIGHT;                                   \
        float nearness = emitter_nearness(light, point);           \
        sum += area_irradiance(light, nearness, point, normal);    \
        near = near == light_end && nearness > 0.0 ? i : near;     \
    }
    AREA_LIGHTS(ADD_AREA)
    do {
        LightData light = light_of_kind(min(near, light_end - 1), kLightAreaSample, 6u);
        float nearness = near < light_end ? emitter_nearness(light, point) : 0.0;
        sum += near_irradiance(light, nearness, point, normal);
        near = next_near_emitter(near + 1, point);
    } while (near < light_end);
#endif
    return sum;
}

// Illuminance on a surface of unit `normal` at `point`, rgb in lux.
vec3 direct_irradiance(vec3 point, vec3 normal) {
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    LampTarget target = matte_target(point, normal);
#endif
#define ADD_PUNCTUAL(LIGHT) sum += punctual_irradiance(LIGHT, point, normal);
    PUNCTUAL_LIGHTS(ADD_PUNCTUAL, target)
    return sum + area_irradiances(point, normal);
}

#endif
