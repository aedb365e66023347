#version 450 core
// Direct light on the discs of light sensors, averaged over kSensorLanes points. One work group a sensor.
#include "sensor_data.h"
#include "direct_irradiance.glsl"

layout(local_size_x = kSensorLanes) in;

layout(std430, binding = kSensorsBinding) readonly buffer Sensors { SensorData sensors[]; };
layout(std430, binding = kSensorIrradianceBinding) writeonly buffer Irradiances { vec4 irradiances[]; };

shared vec3 partial[kSensorLanes];

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
