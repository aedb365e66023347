// Direct light that falls on a point, of all light sources.
#ifndef LANTHORN_DIRECT_IRRADIANCE_GLSL
#define LANTHORN_DIRECT_IRRADIANCE_GLSL
#include "shadow.glsl"
#include "shining_lights.glsl"

// Of one light. `area`: it is an area sample.
vec3 irradiance_of(LightData light, const bool area, vec3 point, vec3 normal) {
    vec3 l;
    float distance;
    vec3 illuminance = area ? area_illuminance(light, point, l, distance) : punctual_illuminance(light, point, l, distance);
    float visibility = area ? area_visibility(light, point, normal, l, distance) : punctual_visibility(light, point, normal, l, distance);
    float weight = dot(normal, l) * visibility;
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

// Illuminance on a surface of unit `normal` at `point`, rgb in lux.
vec3 direct_irradiance(vec3 point, vec3 normal) {
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    LampTarget target = matte_target(point, normal);
#endif
#define ADD_PUNCTUAL(LIGHT) sum += irradiance_of(LIGHT, false, point, normal);
#define ADD_AREA(LIGHT) sum += irradiance_of(LIGHT, true, point, normal);
    PUNCTUAL_LIGHTS(ADD_PUNCTUAL, target)
    AREA_LIGHTS(ADD_AREA)
    return sum;
}

#endif
