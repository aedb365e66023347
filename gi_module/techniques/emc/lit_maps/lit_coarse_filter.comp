#version 450 core
// The mean over 3 x 3 coarse texels of a face, by plane and normal.
layout(local_size_x = 256) in;

#include "lit_coarse.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) writeonly buffer Filtered { vec4 filtered[]; };

uniform float share;  // of the mean in what it gives; the rest is a texel's own

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    if (keys[i] == kNoPoint) return;
    int place = int(keys[i]);
    ivec2 p = ivec2(place % coarse_resolution, place / coarse_resolution % coarse_resolution);
    int face = place / (coarse_resolution * coarse_resolution);
    vec4 point = texelFetch(coarse_points, int(i));
    vec3 n = point_normal(point);
    float tolerance = coarse_tolerance(point.xyz, face);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; ++k) {
        ivec2 off = ivec2(k % 3 - 1, k / 3 - 1);
        float weight = (off.x == 0 ? 0.5 : 0.25) * (off.y == 0 ? 0.5 : 0.25);
        add_coarse(p + off, face, point.xyz, n, tolerance, weight, sum);
    }
    vec4 own = texelFetch(coarse_irradiance, int(i));
    vec3 mean = sum.rgb / max(sum.a, 1e-20);
    filtered[i] = sum.a > 0.0 ? vec4(own.a < 0.0 ? mean : mix(own.rgb, mean, share), 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
