#version 450 core
// Which places candidates see: one invocation for each of both.
layout(local_size_x = 64) in;

#include "seen_from.glsl"

layout(std430, binding = 1) readonly buffer Viewers { int viewers[]; };
layout(std430, binding = 2) readonly buffer Places { vec4 places[]; };  // two each: place, where it is seen from at least
layout(std430, binding = 3) writeonly buffer Seen { uint seen[]; };     // by viewer and place
uniform int place_count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= place_count) return;
    vec3 x = places[2 * i].xyz;
    vec3 towards = normalize(places[2 * i + 1].xyz - x);
    seen[int(gl_WorkGroupID.y) * place_count + i] = seen_from(viewers[gl_WorkGroupID.y], x, towards) ? 1u : 0u;
}
