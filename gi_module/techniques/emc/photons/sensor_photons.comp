#version 450 core
// Adds the photons that have landed on the discs of light sensors. One work group a sensor: its invocations share the
// photons out.
#include "engine/render/octahedral.glsl"
#include "engine/render/sensor_data.h"

layout(local_size_x = kSensorLanes) in;

layout(std430, binding = kSensorsBinding) readonly buffer Sensors { SensorData sensors[]; };
layout(std430, binding = kSensorIrradianceBinding) buffer Irradiances { vec4 irradiances[]; };

#define PHOTON_COUNT_BINDING 2
#include "photon_count.glsl"

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform float layer;  // of a disc's radius: how far off its plane a photon may have landed

shared vec3 partial[kSensorLanes];

const float kLeastTurn = 0.5;  // cosine between a disc's normal and that of the surface that a photon landed on

void main() {
    uint lane = gl_LocalInvocationID.x;
    SensorData sensor = sensors[gl_WorkGroupID.x];
    float r2 = sensor.radius * sensor.radius;
    vec3 sum = vec3(0.0);
    for (int i = int(lane); i < int(photon_set_count); i += int(kSensorLanes)) {
        vec4 place = texelFetch(photon_hits, 2 * i);  // position, bandwidth: 0 for none
        vec3 d = place.xyz - sensor.position;
        float height = dot(d, sensor.normal);
        float across2 = dot(d, d) - height * height;
        if (place.w > 0.0 && across2 < r2 && abs(height) < layer * sensor.radius) {
            vec4 load = texelFetch(photon_hits, 2 * i + 1);  // power, normal
            vec3 normal = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
            if (dot(normal, sensor.normal) > kLeastTurn) sum += load.rgb;
        }
    }
    partial[lane] = sum;
    barrier();
    if (lane == 0u) {
        vec3 all = vec3(0.0);
        for (uint i = 0u; i < kSensorLanes; ++i) all += partial[i];
        irradiances[gl_WorkGroupID.x].rgb += all / (3.14159265359 * r2);
    }
}
