#version 450 core
// Which coarse texels of its face a kernel around each reaches: those 1, 2 and 4 away in eight directions to which its surface
// goes on. A place without a coarse texel remembers nothing. Of the listed places, or all of them.
layout(local_size_x = 256) in;

#include "lit_points.glsl"

layout(std430, binding = 1) buffer Seen { vec4 seen[]; };           // by place: the point that a mean belongs to
layout(std430, binding = 4) writeonly buffer Links { uint links[]; };  // by place: 8 bits each of 1, 2 and 4 away
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform usamplerBuffer coarse_index;  // by place: number + 1
uniform samplerBuffer coarse_points;  // by number
uniform int coarse_resolution;
uniform uint places;  // all of them; 0: those listed
uniform vec4 map_centres[MAX_MAPS];

void main() {
    uint i = work_item();
    if (i >= (places > 0u ? places : listed_count)) return;
    int place = int(places > 0u ? i : list[i]);
    uint number = texelFetch(coarse_index, place).r;
    if (number == 0u) {
        seen[place] = vec4(uintBitsToFloat(kUnlitPoint));
        return;
    }
    ivec2 p = ivec2(place % coarse_resolution, place / coarse_resolution % coarse_resolution);
    int face = place / (coarse_resolution * coarse_resolution);
    vec4 point = texelFetch(coarse_points, int(number) - 1);
    vec3 n = point_normal(point);
    float tolerance = 0.5 * distance(point.xyz, map_centres[face / 6].xyz) / float(coarse_resolution);
    uint reached = 0u;
    for (int k = 0; k < 8; ++k) {
        int ring = k < 4 ? k : k + 1;
        ivec2 towards = ivec2(ring % 3, ring / 3) - 1;
        bool goes_on = true;
        for (int s = 1; s <= 4; ++s) {
            ivec2 q = p + towards * s;
            bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, ivec2(coarse_resolution)));
            q = clamp(q, ivec2(0), ivec2(coarse_resolution - 1));
            uint other_number = texelFetch(coarse_index, (face * coarse_resolution + q.y) * coarse_resolution + q.x).r;
            vec4 other = texelFetch(coarse_points, max(int(other_number) - 1, 0));
            vec3 m = point_normal(other);
            float off = 0.5 * abs(dot(other.xyz - point.xyz, n + m));
            goes_on = goes_on && inside && other_number != 0u && dot(n, m) > 0.9 && off < tolerance;
            bool of_a_kernel = goes_on && s != 3;
            reached |= of_a_kernel ? 1u << (8 * (s >> 1) + k) : 0u;
        }
    }
    links[place] = reached;
}
