#version 450 core
// Lists the lit texels, and the points where their indirect irradiance is computed: of each block of them the one nearest its
// middle.
layout(local_size_x = 256) in;

#include "lit_points.glsl"
#include "gi_module/techniques/emc/gather/point_append.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

layout(std430, binding = 6) writeonly buffer CoarseIndex { uint coarse_index[]; };  // by place: number in the list + 1

uniform int coarse_resolution;
uniform int faces;

void main() {
    int place = int(work_item());
    if (place >= faces * coarse_resolution * coarse_resolution) return;
    ivec3 p = ivec3(place % coarse_resolution, place / coarse_resolution % coarse_resolution, place / (coarse_resolution * coarse_resolution));
    int side = lit_resolution / coarse_resolution;
    int nearest = 1 << 30;
    int found = 0;
    uint lit = 0u;
    for (int k = 0; k < side * side; ++k) {
        ivec2 within = ivec2(k % side, k / side);
        int at = lit_place(ivec3(p.xy * side + within, p.z));
        bool is = is_lit(texelFetch(lit_points, at));
        lit += is ? 1u : 0u;
        ivec2 off = 2 * within + 1 - side;
        int apart = off.x * off.x + off.y * off.y;
        bool nearer = is && apart < nearest;
        nearest = nearer ? apart : nearest;
        found = nearer ? at : found;
    }
    coarse_index[place] = 0u;
    if (lit == 0u) return;
    vec4 point = texelFetch(lit_points, found);
    coarse_index[place] = append_point(point.xyz, point_normal(point), uint(place)) + 1u;
    uint next = append_entries(lit);
    for (int k = 0; k < side * side; ++k) {
        int at = lit_place(ivec3(p.xy * side + ivec2(k % side, k / side), p.z));
        if (is_lit(texelFetch(lit_points, at))) appended[next++] = uint(at);
    }
}
