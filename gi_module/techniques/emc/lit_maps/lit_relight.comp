#version 450 core
// The lit texels whose direct light may be another: those of blocks that show something else, and of those where what movers
// sweep lies between them and a light.
layout(local_size_x = 256) in;

#include "lit_blocks.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

uniform usamplerBuffer changed;  // from word changed_blocks on a bit a block
uniform int changed_blocks;
uniform samplerBuffer lights;    // xyz: where light comes from; w: by how much it widens, a metre. w < 0: from how far away, and
                                 // -w metres everywhere
uniform int light_count;
uniform int blocks;

void main() {
    int block = int(work_item());
    if (block >= blocks) return;
    uint lit = 0u;
    bool relit = (texelFetch(changed, changed_blocks + (block >> 5)).r >> (block & 31) & 1u) != 0u;
    for (int k = 0; k < int(kBlockTexels); ++k) {
        int place = lit_place(texel_of_block(block, k));
        lit |= is_lit(texelFetch(lit_points, place)) ? 1u << k : 0u;
    }
    vec3 lower, upper;
    bounds_of_block(block, lower, upper);
    for (int i = 0; i < light_count; ++i) {
        vec4 light = texelFetch(lights, i);
        bool far = light.w < 0.0;
        vec3 a_lower = light.xyz + (far ? lower : vec3(0.0));
        vec3 a_upper = light.xyz + (far ? upper : vec3(0.0));
        float around = far ? -light.w : light.w * farthest(light.xyz, lower, upper);
        vec3 at_light = vec3(far ? around : 0.0);
        relit = relit || meets_a_box(a_lower - at_light, a_upper + at_light, lower - around, upper + around);
    }
    uint count = relit ? uint(bitCount(lit)) : 0u;
    if (count == 0u) return;
    uint at = append_entries(count);
    for (int k = 0; k < int(kBlockTexels); ++k) {
        if ((lit >> k & 1u) != 0u) appended[at++] = uint(lit_place(texel_of_block(block, k)));
    }
}
