#version 450 core
// Of the lit texels in the listed blocks: which of the four coarse texels around each lie on its surface, a bit each.
layout(local_size_x = 256) in;

#include "lit_coarse.glsl"
#include "lit_points.glsl"

layout(std430, binding = 4) writeonly buffer Fits { uint fits[]; };  // by place
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform uint blocks;  // all of them; 0: those listed

void main() {
    uint i = work_item();
    if (i >= (blocks > 0u ? blocks : listed_count) * kBlockTexels) return;
    ivec3 p = texel_of_block(BLOCK_OF(i / kBlockTexels), int(i % kBlockTexels));
    int place = lit_place(p);
    vec4 point = texelFetch(lit_points, place);
    vec3 n = point_normal(point);
    float tolerance = coarse_tolerance(point.xyz, p.z);
    ivec2 base = ivec2(floor(coarse_position(p.xy, lit_resolution)));
    uint bits = 0u;
    for (int k = 0; k < 4; ++k) {
        bits |= number_on_surface(base + ivec2(k & 1, k >> 1), p.z, point.xyz, n, tolerance) != 0u ? 1u << k : 0u;
    }
    fits[place] = bits;
}
