#version 450 core
// The blocks of lit texels that may show something else after things have moved: where what movers sweep lies between the
// centre of any map and what a block sees. ALL 1: all of them.
layout(local_size_x = 256) in;

#define INVOCATIONS kBlockTexels
#include "intersection.glsl"
#include "lit_maps.glsl"
#include "lit_blocks.glsl"
#include "entry_list.glsl"

void main() {
    int block = int(work_item());
    int side = lit_resolution / kBlock;
    if (block >= map_count * 6 * side * side) return;
    bool touched = false;
#if !ALL
    vec3 lower, upper;
    bounds_of_block(block, lower, upper);
    for (int s = 0; s < map_count; ++s) {
        vec3 c = map_centres[s].xyz;
        // Its texels see a little more than their middles: half a texel, and one of the map's own.
        float around = 4.0 / float(lit_resolution) * farthest(c, lower, upper);
        touched = touched || (slot_in_use(s, 0.0) && meets_a_box(c, c, lower - around, upper + around));
    }
    touched = touched && slot_in_use(block / (6 * side * side), 0.0);
#else
    touched = true;
#endif
    if (touched) list_entry(uint(block));
}
