#version 450 core
// Begins the guides of a frame: a group a tile. Where enough starts serve a tile, what it knew from frames before counts on, less
// the share that this frame adds.
layout(local_size_x = 64) in;

#include "remembered_guide.glsl"
#include "gather_surface.glsl"

layout(std430, binding = 2) buffer Guide { uvec2 guide[]; };
layout(std430, binding = 3) writeonly buffer Means { float means[]; };  // lux

uniform samplerBuffer irradiance;  // of the points as they were shaded last
uniform usamplerBuffer counts;     // of starts that serve them
uniform ivec2 grid;
uniform uint slots;  // of which one is added; 1: all are, and nothing counts on

const float kEnough = 8.0;  // starts a point

shared vec3 sums[64];

void main() {
    uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint i = gl_LocalInvocationID.x;
    ivec2 p = ivec2(gl_WorkGroupID.xy) * 8 + ivec2(i & 7u, i >> 3u);
    bool inside = all(lessThan(p, grid));
    p = min(p, grid - 1);
    int at = p.y * grid.x + p.x;
    vec4 e = texelFetch(irradiance, at);
    sums[i] = inside && e.a >= 0.0 ? vec3(luminance(e.rgb), 1.0, float(texelFetch(counts, at).r)) : vec3(0.0);
    barrier();
    vec3 sum = vec3(0.0);
    for (int k = 0; k < 64; ++k) sum += sums[k];
    uvec2 before = guide[tile * kGuideCells + i];
    guide[tile * kGuideCells + i] = sum.z < kEnough * sum.y ? uvec2(0u) : before - (before + slots - 1u) / slots;
    if (i == 0u) means[tile] = sum.x / max(sum.y, 1.0);
}
