#version 450 core
// The points where indirect irradiance of the lit maps is computed: of each block of lit texels the one nearest its middle.
layout(local_size_x = 256) in;

#include "point_append.glsl"

layout(std430, binding = 4) readonly buffer LitIndex { uint lit_index[]; };
layout(std430, binding = 5) readonly buffer LitPoints { vec4 lit_points[]; };
layout(std430, binding = 6) writeonly buffer CoarseIndex { uint coarse_index[]; };  // by place: number in the list + 1

uniform int lit_resolution;
uniform int coarse_resolution;
uniform int faces;

void main() {
    int place = int(work_item());
    if (place >= faces * coarse_resolution * coarse_resolution) return;
    ivec2 p = ivec2(place % coarse_resolution, place / coarse_resolution % coarse_resolution);
    int face = place / (coarse_resolution * coarse_resolution);
    int side = lit_resolution / coarse_resolution;
    int nearest = 1 << 30;
    uint found = 0u;
    for (int k = 0; k < side * side; ++k) {
        ivec2 within = ivec2(k % side, k / side);
        ivec2 q = p * side + within;
        uint number = lit_index[(face * lit_resolution + q.y) * lit_resolution + q.x];
        ivec2 off = 2 * within + 1 - side;
        int apart = off.x * off.x + off.y * off.y;
        bool nearer = number != 0u && apart < nearest;
        nearest = nearer ? apart : nearest;
        found = nearer ? number : found;
    }
    coarse_index[place] = 0u;
    if (found == 0u) return;
    vec4 point = lit_points[found - 1u];
    coarse_index[place] = append_point(point.xyz, point_normal(point), uint(place)) + 1u;
}
