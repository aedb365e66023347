#version 450 core
// Irradiance at points: the mean of what the lit texels reflect that their rays have met, and the mean square of its luminance.
layout(local_size_x = 64) in;

#include "lit_hits.glsl"
#include "point_lists.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) writeonly buffer Irradiance { vec4 irradiance[]; };  // lux; a: lux^2, -1: nothing is known

uniform usamplerBuffer hits;      // by slot, ray and point
uniform samplerBuffer radiosity;  // by lit texel, lux
uniform int capacity;
uniform int taken;                // rays remembered, a point

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    vec3 sum = vec3(0.0);
    float squares = 0.0;
    float known = 0.0;
    for (int k = 0; k < taken; ++k) {
        uint hit = texelFetch(hits, k * capacity + int(i)).r;
        vec3 b = texelFetch(radiosity, hit < kUnknown ? int(hit) : 0).rgb;
        b = hit < kUnknown ? b : vec3(0.0);
        float y = dot(b, vec3(0.2126, 0.7152, 0.0722));
        sum += b;
        squares += y * y;
        known += hit == kUnknown ? 0.0 : 1.0;
    }
    vec3 mean = sum / max(known, 1.0);
    irradiance[i] = vec4(mean, known > 0.0 ? squares / known : -1.0);
}
