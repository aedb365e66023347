// Blocks of 2x2 pixels of one level that lie between the same four pixels of the coarser one, and what is kept of each:
// 16 bits of which coarse pixels lie on which pixel's surface, 4 of which pixels show a surface at all, 4 of which have their
// boundaries already (splat_boundaries.comp).
#ifndef LANTHORN_EMC_SPLAT_BLOCKS_GLSL
#define LANTHORN_EMC_SPLAT_BLOCKS_GLSL

uniform ivec2 level_size;
uniform ivec2 coarse_size;

ivec2 corner(int k) { return ivec2(k & 1, k >> 1); }
ivec2 block_pixel(ivec2 block, int j) { return 2 * block - 1 + corner(j); }
ivec2 coarse_pixel(ivec2 block, int k) { return block - 1 + corner(k); }

uint same_bit(int j, int k) { return 1u << uint(4 * j + k); }
uint surface_bit(int j) { return 1u << uint(16 + j); }
uint known_bit(int j) { return 1u << uint(20 + j); }

#endif
