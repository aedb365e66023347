#version 450 core
// The rays of the listed entries, to be traced outside of the maps (exact_rays.h).
layout(local_size_x = 256) in;

#include "remembered.glsl"

layout(std430, binding = 4) writeonly buffer Requests { vec4 requests[]; };  // two a ray: origin; direction
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform usamplerBuffer flights;
uniform float origin_offset;  // m, along the normal

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    int entry = int(list[item]);
    vec4 start = texelFetch(starts, start_of(uint(entry)));
    requests[2u * item] = vec4(start.xyz + point_normal(start) * origin_offset, 0.0);
    requests[2u * item + 1u] = vec4(unpack_direction(texelFetch(flights, entry).x), 0.0);
}
