#version 450 core
// New coverage area A(v|C) of eq. 1 (Yao et al. 2010), with the shadow test done in the candidates' own 32x32x6 maps.
// An invocation sums kPixels pixels of one candidate, kApart apart, as a tree of sums would; the others are added in a fixed order
// afterwards. No barrier: a software rasteriser pays more for one than for what a pixel does.
layout(local_size_x = 64) in;

#include "seen_from.glsl"

layout(std430, binding = 1) readonly buffer Viewers { int viewers[]; };    // the v to measure
layout(std430, binding = 2) readonly buffer Selected { int selected[]; };  // C; v itself is passed over
layout(std430, binding = 3) writeonly buffer Partial { vec4 partial[]; };  // x: A(v|C), y: backs seen, z: hits, w: min distance
uniform int selected_count;
uniform float reach;  // metres: beyond it areas count less by the square of their distance

const int kPixels = 8;
const int kApart = 8;

vec4 added(vec4 a, vec4 b) { return vec4(a.xyz + b.xyz, min(a.w, b.w)); }

// Of a pixel, counted over the six faces.
vec4 sum_of(int v, int pixel) {
    int pixels = resolution * resolution;
    int face = pixel / pixels;
    ivec2 p = ivec2(pixel % resolution, (pixel % pixels) / resolution);
    vec4 plane = texelFetch(candidate_planes, ivec3(p, v * 6 + face), 0);
    vec4 sum = vec4(0.0, 0.0, 0.0, 1e30);
    if (plane.w != 0.0) {
        vec3 direction = cube_direction(face, (vec2(p) + 0.5) / float(resolution));  // dot with the face's forward is 1
        float l = length(direction);
        float distance_p = abs(plane.w);
        sum.w = distance_p;
        float solid_angle = 4.0 / (float(pixels) * l * l * l);
        sum.y = plane.w < 0.0 ? solid_angle : 0.0;
        sum.z = solid_angle;
        if (plane.w > 0.0) {
            vec3 x_minus_v = direction * (distance_p / l);
            vec3 n = -normalize(plane.xyz);
            bool shadow = true;
            for (int i = 0; i < selected_count && shadow; ++i) {
                shadow = selected[i] == v || !seen_from(selected[i], centres[v].xyz + x_minus_v, n);
            }
            if (shadow) {
                // Eq. 1. (v - x).n vanishes at grazing angles, where one pixel would claim more surface than its footprint can
                // vouch for: cos(alpha) is kept above the angle a pixel subtends.
                float depth = distance_p / l;  // (x - v).r
                float facing = max(dot(-x_minus_v, n), distance_p * 2.0 / float(resolution));
                float far = max(distance_p / reach, 1.0);
                sum.x = 4.0 / float(pixels) * depth * depth * depth / (facing * far * far);
            }
        }
    }
    return sum;
}

void main() {
    int item = int(gl_GlobalInvocationID.x);
    int v = viewers[gl_WorkGroupID.y];
    int first = item / kApart * kApart * kPixels + item % kApart;
    vec4 sums[kPixels];
    for (int k = 0; k < kPixels; ++k) sums[k] = sum_of(v, first + kApart * k);
    vec4 even = added(added(sums[0], sums[4]), added(sums[2], sums[6]));
    vec4 odd = added(added(sums[1], sums[5]), added(sums[3], sums[7]));
    partial[gl_WorkGroupID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x] = added(even, odd);
}
