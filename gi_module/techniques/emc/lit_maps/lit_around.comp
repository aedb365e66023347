#version 450 core
// What is due around the listed blocks, which show something else than before: the blocks whose texels may be counted by other
// coarse texels, up to one away, and the coarse texels whose kernels reach theirs.
layout(local_size_x = 256) in;

#define INVOCATIONS kBlockTexels
#include "lit_points.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

layout(std430, binding = 4) buffer Reached { uint reached_count; uint reached_groups[3]; uint reached[]; };  // coarse places
layout(std430, binding = 5) buffer Marks { uint marks[]; };  // a bit each of what is on a list: blocks, then coarse places
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform int coarse_resolution;
uniform uint first_coarse;  // word of `marks`

const int kReach = 4;  // coarse texels: lit_photon_links.comp

// Whether nobody has marked it before.
bool mark(uint first_word, uint i) {
    uint bit = 1u << (i & 31u);
    return (atomicOr(marks[first_word + (i >> 5)], bit) & bit) == 0u;
}

bool is_inside(ivec2 p, int resolution) { return all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, ivec2(resolution))); }

// Where a face ends there is none.
void reach(ivec2 q, int face) {
    if (!is_inside(q, coarse_resolution)) return;
    uint place = uint((face * coarse_resolution + q.y) * coarse_resolution + q.x);
    if (!mark(first_coarse, place)) return;
    uint at;
    TAKE_PLACES(reached_count, 1u, at)
    reached[at] = place;
    COUNT_GROUPS(reached_groups, at, at, 256u)
}

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    ivec3 p = texel_of_block(int(list[i]), 0);
    int blocks_a_side = lit_resolution / kBlock;
    for (int k = 0; k < 9; ++k) {
        ivec2 b = p.xy / kBlock + ivec2(k % 3, k / 3) - 1;
        uint block = uint((p.z * blocks_a_side + b.y) * blocks_a_side + b.x);
        if (is_inside(b, blocks_a_side) && mark(0u, block)) list_entry(block);
    }
    int side = lit_resolution / coarse_resolution;
    int a_row = kBlock / side;
    for (int c = 0; c < a_row * a_row; ++c) {
        ivec2 q = p.xy / side + ivec2(c % a_row, c / a_row);
        reach(q, p.z);
        for (int k = 0; k < 8 * kReach; ++k) {
            int ring = k % 8 < 4 ? k % 8 : k % 8 + 1;
            reach(q + (ivec2(ring % 3, ring / 3) - 1) * (k / 8 + 1), p.z);
        }
    }
}
