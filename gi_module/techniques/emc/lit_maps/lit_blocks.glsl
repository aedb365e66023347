// Blocks of lit texels, and whether what movers sweep lies between such a block and something that it looks at.
#ifndef LANTHORN_EMC_LIT_BLOCKS_GLSL
#define LANTHORN_EMC_LIT_BLOCKS_GLSL

#include "lit_points.glsl"
#include "gi_module/techniques/emc/gather/swept_boxes.glsl"

// The box around the points that a block's texels see.
void bounds_of_block(int block, out vec3 lower, out vec3 upper) {
    lower = vec3(3e38);
    upper = vec3(-3e38);
    for (int k = 0; k < int(kBlockTexels); ++k) {
        vec3 x = texelFetch(lit_points, lit_place(texel_of_block(block, k))).xyz;
        lower = min(lower, x);
        upper = max(upper, x);
    }
}

float farthest(vec3 x, vec3 lower, vec3 upper) { return length(max(abs(lower - x), abs(upper - x))); }

// Whether a box that goes and grows evenly from `a` to `b` meets on its way what movers sweep.
bool meets_a_box(vec3 a_lower, vec3 a_upper, vec3 b_lower, vec3 b_upper) {
    vec3 d = b_lower - a_lower;
    vec3 e = b_upper - a_upper;
    vec3 one_d = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    vec3 one_e = 1.0 / mix(e, vec3(1e-20), lessThan(abs(e), vec3(1e-20)));
    bool meets = false;
    for (int i = 0; i < BOXES; ++i) {
        // a_lower + t d <= box_upper and a_upper + t e >= box_lower
        vec3 u = (box_upper[i].xyz - a_lower) * one_d;
        vec3 v = (box_lower[i].xyz - a_upper) * one_e;
        vec3 enter = max(mix(u, vec3(-3e38), greaterThanEqual(one_d, vec3(0.0))), mix(v, vec3(-3e38), lessThan(one_e, vec3(0.0))));
        vec3 leave = min(mix(u, vec3(3e38), lessThan(one_d, vec3(0.0))), mix(v, vec3(3e38), greaterThanEqual(one_e, vec3(0.0))));
        meets = meets || max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, 1.0));
    }
    return meets;
}

#endif
