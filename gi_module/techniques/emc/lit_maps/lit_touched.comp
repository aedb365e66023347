#version 450 core
// The blocks of lit texels that may show something else after things have moved: where what movers sweep lies between what a
// block sees and the centre of its map, or of another that would show it sharper. ALL 1: all of them.
layout(local_size_x = 256) in;

#define INVOCATIONS kBlockTexels
#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_maps.glsl"
#include "lit_blocks.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

layout(std430, binding = 6) buffer Sharper { uvec2 sharper[]; };  // by block: bits of those others

void main() {
    int block = int(work_item());
    int side = lit_resolution / kBlock;
    if (block >= map_count * 6 * side * side) return;
#if ALL
    bool touched = true;
#else
    vec3 lower, upper;
    bounds_of_block(block, lower, upper);
    int own = block / (6 * side * side);
    uvec2 to_ask = sharper[block];
    to_ask[own >> 5] |= 1u << (own & 31);
    bool touched = false;
    while (!touched && (to_ask.x | to_ask.y) != 0u) {
        int s = take_first(to_ask);
        vec3 c = map_centres[s].xyz;
        // Its texels see a little more than their middles: half a texel, and one of the map's own.
        float around = 4.0 / float(lit_resolution) * farthest(c, lower, upper);
        touched = meets_a_box(c, c, lower - around, upper + around);
    }
    touched = touched && slot_in_use(own, 0.0);
#endif
    if (!touched) return;
    sharper[block] = uvec2(0u);
    list_entry(uint(block));
}
