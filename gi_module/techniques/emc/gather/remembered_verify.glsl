// What becomes of a remembered ray after something has moved.
#ifndef LANTHORN_EMC_REMEMBERED_VERIFY_GLSL
#define LANTHORN_EMC_REMEMBERED_VERIFY_GLSL

#include "remembered.glsl"
#if GRID
#include "swept_grid.glsl"
#else
#include "swept_boxes.glsl"
#endif

uniform usamplerBuffer remembered;  // texels
uniform samplerBuffer starts;
uniform usamplerBuffer flights;     // direction, distance
uniform usamplerBuffer changed;     // a bit a place: the lit texel shows something else than in the frame before
#if IN_PICTURE
uniform usamplerBuffer cells;       // by start
#endif
uniform int frame;
uniform bool other_maps;            // than when rays were verified last
uniform float scene_diagonal;
uniform float local_length;         // EnvironmentMaps::extent()

// Whether the rays of a start that lies within what is swept are stale. What a mover carries along still meets nearly the same: a quarter
// of it is traced again, in turns.
bool inside_is_stale(int start, uint slot) {
#if IN_PICTURE
    bool is_carried = (texelFetch(cells, start).y & kCarried) != 0u;
    return !is_carried || (slot & 3u) == (uint(frame) & 3u);
#else
    return true;
#endif
}

// Whether what a ray met, `id`, is to be looked up again: the texel shows something else. What met nothing known may be shown by
// now; that is looked for at once where a map is another, else once in a round of slots.
bool is_looked_up(uint id, uint slot, bool nothing) {
    return id < kNoRay ? (texelFetch(changed, int(id >> 5u)).r >> (id & 31u) & 1u) != 0u : !nothing && (other_maps || slot == uint(frame));
}

// Whether what movers sweep makes a ray stale. `l`: how far it came; 0: it met nothing.
bool movers_make_stale(vec3 x, vec3 d, float l, bool if_inside) {
    float end = l == 0.0 ? scene_diagonal : l;
#if GRID
    return crosses_the_grid(x, d, end, if_inside);
#else
    bool inside;
    bool crosses = crosses_a_box(x, d, end, inside);
    return crosses || (inside && if_inside);
#endif
}

#endif
