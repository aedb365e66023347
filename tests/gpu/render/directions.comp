#version 450 core
// Directions of engine/render/random.glsl as its users get them: `count` about each normal, from the same numbers.
layout(local_size_x = 64) in;

#include "engine/render/random.glsl"

layout(std430, binding = 0) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = 1) writeonly buffer Directions { vec4 directions[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count * normals.length()) return;
    uvec2 u = uint(i % count + 1) * uvec2(3242174889u, 2447445414u);  // R2, Roberts 2018
    directions[i] = vec4(cosine_direction(normals[i / count].xyz, vec2(u >> 8u) * (1.0 / 16777216.0)), 0.0);
}
