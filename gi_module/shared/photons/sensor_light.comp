#version 450 core
// Adds light that the processor has estimated to light sensors.
layout(local_size_x = 64) in;

#include "engine/render/sensor_data.h"

layout(std430, binding = kSensorIrradianceBinding) buffer Irradiances { vec4 irradiances[]; };
layout(std430, binding = 2) readonly buffer Light { vec4 light[]; };  // lux

uniform int sensor_count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < sensor_count) irradiances[i].rgb += light[i].rgb;
}
