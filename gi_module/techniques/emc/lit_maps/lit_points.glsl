// What the lit texels see, by their places in lists over all maps.
#ifndef LANTHORN_EMC_LIT_POINTS_GLSL
#define LANTHORN_EMC_LIT_POINTS_GLSL

#include "gi_module/techniques/emc/gather/point_lists.glsl"

uniform int lit_resolution;        // lit texels a cube-face edge
uniform samplerBuffer lit_points;  // by place: a packed point; of texels that are not lit kUnlitPoint instead of a normal
uniform int lit_sheets;            // where, by place too, what stands on them is kept: planes of two texels of the map, 0 for none

const uint kUnlitPoint = 0x3f808000u;  // what no normal is packed into
const int kBlock = 4;                  // lit texels a side: LitTexels::kBlock
const uint kBlockTexels = 16u;

bool is_lit(vec4 point) { return floatBitsToUint(point.w) != kUnlitPoint; }

int lit_place(ivec3 p) { return (p.z * lit_resolution + p.y) * lit_resolution + p.x; }

// The k-th lit texel of a block: its place on the face, and that.
ivec3 texel_of_block(int block, int k) {
    int side = lit_resolution / kBlock;
    ivec2 p = ivec2(block % side, block / side % side) * kBlock + ivec2(k % kBlock, k / kBlock);
    return ivec3(p, block / (side * side));
}

// The k-th of the listed blocks, or of all where there is no list.
#define BLOCK_OF(k) int(blocks > 0u ? (k) : list[k])

// Takes the lowest of the bits away and gives its number; there is one.
int take_first(inout uvec2 bits) {
    bool low = bits.x != 0u;
    int first = findLSB(low ? bits.x : bits.y);
    bits = low ? uvec2(bits.x & (bits.x - 1u), bits.y) : uvec2(0u, bits.y & (bits.y - 1u));
    return low ? first : first + 32;
}

#endif
