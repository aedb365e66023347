#version 450 core
// Adds the light of the direct radiance maps' samples to light sensors, at the middle of each: it varies little over a disc.
layout(local_size_x = 64) in;

#include "engine/render/sensor_data.h"
#include "radiance_sample.h"
#ifdef SAMPLES_ARE_HIDDEN
#include "hidden_sample.glsl"
#endif
#include "drm_gather.glsl"

layout(std430, binding = kSensorsBinding) readonly buffer Sensors { SensorData sensors[]; };
layout(std430, binding = kSensorIrradianceBinding) buffer Irradiances { vec4 irradiances[]; };

uniform int sensor_count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= sensor_count) return;
    irradiances[i].rgb += gathered_irradiance(sensors[i].position, sensors[i].normal);
}
