#version 450 core
// Of the listed blocks of texels: puts those that are lit on the list of them, and into the list of coarse points, of each coarse
// texel, the lit texel nearest its middle. What is on a list keeps its place there: a texel that is lit no more is passed over by
// who reads the list, and a coarse point that is none any more has no key, until its texel has one again.
layout(local_size_x = 256) in;

#include "lit_points.glsl"
#include "gi_module/techniques/emc/gather/point_append.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

// By block: 16 bits of what is lit, and 16 higher ones of what is on the list; behind them how many texels are lit.
layout(std430, binding = 2) buffer Held { uint held[]; };
layout(std430, binding = 4) buffer Given { uint given[]; };  // by coarse place: the number that it has been given + 1
layout(std430, binding = 5) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
layout(std430, binding = 6) writeonly buffer CoarseIndex { uint coarse_index[]; };  // by place: number in the list + 1

uniform int coarse_resolution;
uniform uint blocks;
uniform bool whole;  // of all blocks; the lists are empty

// The lit texel of a block that is nearest the middle of the c-th of its coarse texels, `side` texels wide; -1: none.
int nearest_lit(uint lit, int c, int side) {
    ivec2 first = ivec2(c % (kBlock / side), c / (kBlock / side)) * side;
    int nearest = 1 << 30;
    int found = -1;
    for (int k = 0; k < side * side; ++k) {
        ivec2 within = ivec2(k % side, k / side);
        ivec2 off = 2 * within + 1 - side;
        int apart = off.x * off.x + off.y * off.y;
        int of_block = (first.y + within.y) * kBlock + first.x + within.x;
        bool nearer = (lit >> of_block & 1u) != 0u && apart < nearest;
        nearest = nearer ? apart : nearest;
        found = nearer ? of_block : found;
    }
    return found;
}

void set_coarse(uint place, vec4 point, bool is) {
    uint number = given[place];
    if (is && number == 0u) {
        number = append_point(point.xyz, point_normal(point), place) + 1u;
        given[place] = number;
    } else if (number != 0u) {
        points[number - 1u] = pack_point(point.xyz, point_normal(point));
        keys[number - 1u] = is ? place : kNoPoint;
    }
    coarse_index[place] = is ? number : 0u;
}

void main() {
    uint item = work_item();
    if (item >= (whole ? blocks : listed_count)) return;
    int block = int(whole ? item : list[item]);
    uint lit = 0u;
    for (int k = 0; k < int(kBlockTexels); ++k) {
        lit |= is_lit(texelFetch(lit_points, lit_place(texel_of_block(block, k)))) ? 1u << k : 0u;
    }
    uint before = held[block];
    uint fresh = lit & ~(before >> 16);
    held[block] = before & 0xffff0000u | fresh << 16 | lit;
    uint more = uint(bitCount(lit)) - uint(bitCount(before & 0xffffu));  // modulo 2^32
    if (more != 0u) atomicAdd(held[blocks], more);

    int side = lit_resolution / coarse_resolution;
    int a_row = kBlock / side;
    for (int c = 0; c < a_row * a_row; ++c) {
        int found = nearest_lit(lit, c, side);
        ivec3 p = texel_of_block(block, max(found, 0));
        ivec2 q = texel_of_block(block, 0).xy / side + ivec2(c % a_row, c / a_row);
        set_coarse(uint((p.z * coarse_resolution + q.y) * coarse_resolution + q.x), texelFetch(lit_points, lit_place(p)), found >= 0);
    }
    if (fresh == 0u) return;
    uint next = append_entries(uint(bitCount(fresh)));
    while (fresh != 0u) {
        appended[next++] = uint(lit_place(texel_of_block(block, findLSB(fresh))));
        fresh &= fresh - 1u;
    }
}
