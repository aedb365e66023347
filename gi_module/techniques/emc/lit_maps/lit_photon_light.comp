#version 450 core
// Indirect irradiance of the coarse texels: power over area under the kernel that holds enough photons. How many a kernel is
// likely to hold tells the widest: were each judged by its own, those that have many by chance would be believed. Where even that
// is likely to hold few, the surface is small, and what lies around it on the face, turned alike, tells the rest.
layout(local_size_x = 256) in;

#include "lit_points.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) writeonly buffer Irradiance { vec4 irradiance[]; };  // lux, by number; a < 0: nothing is known

// By place: rgb lumen, a m^2; from the narrowest kernel to the widest.
uniform samplerBuffer kernel_0;
uniform samplerBuffer kernel_1;
uniform samplerBuffer kernel_2;
uniform samplerBuffer kernel_3;
uniform usamplerBuffer coarse_index;  // by place: number + 1
uniform samplerBuffer coarse_points;  // by number
uniform int coarse_resolution;
uniform vec3 photons;  // that carry a lumen of each channel
uniform float enough;  // photons under a kernel
uniform float few;     // under the widest

const int kAround = 3;  // coarse texels from a kernel to those around it

vec3 over(vec4 sum) { return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0); }

// Under the widest kernels around a place, whatever surfaces they are of.
vec4 around(int place, vec3 n) {
    ivec2 p = ivec2(place % coarse_resolution, place / coarse_resolution % coarse_resolution);
    int face = place / (coarse_resolution * coarse_resolution);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; ++k) {
        ivec2 q = p + kAround * (ivec2(k % 3, k / 3) - 1);
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, ivec2(coarse_resolution)));
        q = clamp(q, ivec2(0), ivec2(coarse_resolution - 1));
        int at = (face * coarse_resolution + q.y) * coarse_resolution + q.x;
        uint number = texelFetch(coarse_index, at).r;
        vec3 m = point_normal(texelFetch(coarse_points, max(int(number) - 1, 0)));
        bool alike = inside && number != 0u && dot(n, m) > 0.0;
        sum += alike ? texelFetch(kernel_3, at) : vec4(0.0);
    }
    return sum;
}

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    if (keys[i] == kNoPoint) return;
    int place = int(keys[i]);
    vec4 sums[4] = vec4[4](texelFetch(kernel_0, place), texelFetch(kernel_1, place), texelFetch(kernel_2, place), texelFetch(kernel_3, place));
    float density = dot(over(sums[3]), photons);  // a square metre
    vec4 all = around(place, point_normal(texelFetch(coarse_points, int(i))));
    float own = clamp(dot(over(all), photons) * sums[3].a / few, 0.0, 1.0);
    vec3 e = vec3(0.0);
    float taken = 0.0;
    for (int k = 0; k < 4; ++k) {
        float share = k == 3 ? 1.0 : clamp(density * sums[k].a / enough, taken, 1.0);
        e += (share - taken) * over(sums[k]);
        taken = share;
    }
    irradiance[i] = all.a > 0.0 ? vec4(mix(over(all), e, own), 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
