// The numbers that the directions of rays come from. Needs remembered.glsl.
#ifndef LANTHORN_EMC_RAY_NUMBERS_GLSL
#define LANTHORN_EMC_RAY_NUMBERS_GLSL

#include "engine/render/random.glsl"

uniform int row;    // points a row of keys: of the picture's grid, or of a map's face
uniform uint seed;
uniform int pass;   // of rays that are not remembered, from 0

const uint kStretch = kRemembered > 1u ? kRemembered : 65536u;  // of the sequence, that a point has: slots, or passes

// Place of a point in its tile of 8 x 8: near ones far apart (Bayer 1973).
uint rank_in_tile(uvec2 p) {
    uint rank = 0u;
    for (uint b = 0u; b < 3u; ++b) {
        rank = (rank << 2u) | ((((p.x ^ p.y) >> b) & 1u) << 1u) | ((p.y >> b) & 1u);
    }
    return rank;
}

// Two low-discrepancy numbers (R2, Roberts 2018) of the j-th ray of a slot: each point has its stretch of the sequence, by its
// rank, each tile a shift of its own.
vec2 ray_numbers(uint key, uint slot, uint j) {
    uvec2 p = uvec2(key % uint(row), key / uint(row));
    uint tile = p.y / 8u * ((uint(row) + 7u) / 8u) + p.x / 8u;
    uint n = (rank_in_tile(p & 7u) * kStretch + slot + uint(pass)) * uint(rays) + j + 1u;
    uvec2 u = n * uvec2(3242174889u, 2447445414u) + pcg4d(uvec4(seed, tile, 31u, 37u)).xy;
    return vec2(u >> 8u) * (1.0 / 16777216.0);
}

#endif
