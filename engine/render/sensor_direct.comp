#version 450 core
// Direct light on the discs of light sensors, averaged over kSensorLanes points. One work group a sensor.
#include "sensor_data.h"
#include "shadow.glsl"

layout(local_size_x = kSensorLanes) in;

layout(std430, binding = kSensorsBinding) readonly buffer Sensors { SensorData sensors[]; };
layout(std430, binding = kSensorIrradianceBinding) writeonly buffer Irradiances { vec4 irradiances[]; };

uniform int light_count;
uniform int punctual_count;

shared vec3 partial[kSensorLanes];

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

void main() {
    uint lane = gl_LocalInvocationID.x;
    SensorData sensor = sensors[gl_WorkGroupID.x];
    vec3 n = sensor.normal;
    vec3 t = normalize(abs(n.x) < 0.5 ? vec3(0.0, -n.z, n.y) : vec3(-n.y, n.x, 0.0));
    // Points of equal area each, on a spiral of the golden angle (Vogel 1979).
    float r = sensor.radius * sqrt((float(lane) + 0.5) / float(kSensorLanes));
    float angle = 2.39996323 * float(lane);
    vec3 point = sensor.position + r * (cos(angle) * t + sin(angle) * cross(n, t));
    partial[lane] = direct_irradiance(point, n);
    barrier();
    if (lane == 0u) {
        vec3 sum = vec3(0.0);
        for (uint i = 0u; i < kSensorLanes; ++i) sum += partial[i];
        irradiances[gl_WorkGroupID.x] = vec4(sum / float(kSensorLanes), 0.0);
    }
}
