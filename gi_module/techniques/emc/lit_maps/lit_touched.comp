#version 450 core
// The blocks of lit texels that may show something else after things have moved: where what movers sweep lies between what a
// block sees and the centre of its map, or of another that would show it sharper; and after a map has taken the place of another,
// where it is theirs, or one of them shows what the block sees at least as sharply. ALL 1: all of them.
layout(local_size_x = 256) in;

#define INVOCATIONS kBlockTexels
#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_maps.glsl"
#include "lit_blocks.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

layout(std430, binding = 6) buffer Sharper { uvec2 sharper[]; };  // by block: bits of those others

#if !ALL
uniform ivec2 exchanged;  // slots of the map that came and of the one that left; -1: none

// Whether such a slot's map shows the surface of a lit texel as sharply as the texel's own.
bool may_be_theirs(int block, int own) {
    bool theirs = false;
    for (int k = 0; k < int(kBlockTexels); ++k) {
        vec4 point = texelFetch(lit_points, lit_place(texel_of_block(block, k)));
        vec3 n = point_normal(point);
        float least = sharpness(point.xyz - map_centres[own].xyz, n);
        bool sharper = max(sharpness(point.xyz - map_centres[exchanged.x].xyz, n),
                           sharpness(point.xyz - map_centres[exchanged.y].xyz, n)) >= least;
        theirs = theirs || (is_lit(point) && sharper);
    }
    return theirs;
}
#endif

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
    bool others = exchanged.x >= 0;
    bool touched = others && (own == exchanged.x || own == exchanged.y);
    while (others && !touched) {
        uvec2 asked = uvec2(to_ask[exchanged.x >> 5] >> (exchanged.x & 31), to_ask[exchanged.y >> 5] >> (exchanged.y & 31));
        touched = ((asked.x | asked.y) & 1u) != 0u || may_be_theirs(block, own);
        others = false;
    }
    bool left = touched && own == exchanged.y;
    while (!touched && (to_ask.x | to_ask.y) != 0u) {
        int s = take_first(to_ask);
        vec3 c = map_centres[s].xyz;
        // Its texels see a little more than their middles: half a texel, and one of the map's own.
        float around = 4.0 / float(lit_resolution) * farthest(c, lower, upper);
        touched = meets_a_box(c, c, lower - around, upper + around);
    }
    touched = touched && (left || slot_in_use(own, 0.0));
#endif
    if (!touched) return;
    sharper[block] = uvec2(0u);
    list_entry(uint(block));
}
