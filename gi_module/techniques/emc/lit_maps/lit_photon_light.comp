#version 450 core
// Indirect irradiance of the coarse texels: power over area under the kernel that holds enough photons. How many a kernel is
// likely to hold tells the widest: were each judged by its own, those that have many by chance would be believed.
layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) writeonly buffer Irradiance { vec4 irradiance[]; };  // lux, by number; a < 0: nothing is known

#include "gi_module/techniques/emc/gather/point_lists.glsl"

// By place: rgb lumen, a m^2; from the narrowest kernel to the widest.
uniform samplerBuffer kernel_0;
uniform samplerBuffer kernel_1;
uniform samplerBuffer kernel_2;
uniform samplerBuffer kernel_3;
uniform vec3 photons;        // that carry a lumen of each channel
uniform float enough;        // photons under a kernel

vec3 over(vec4 sum) { return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0); }

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    int place = int(keys[i]);
    vec4 sums[4] = vec4[4](texelFetch(kernel_0, place), texelFetch(kernel_1, place), texelFetch(kernel_2, place), texelFetch(kernel_3, place));
    float density = dot(over(sums[3]), photons);  // a square metre
    vec3 e = vec3(0.0);
    float taken = 0.0;
    for (int k = 0; k < 4; ++k) {
        float share = k == 3 ? 1.0 : clamp(density * sums[k].a / enough, taken, 1.0);
        e += (share - taken) * over(sums[k]);
        taken = share;
    }
    irradiance[i] = sums[3].a > 0.0 ? vec4(e, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
