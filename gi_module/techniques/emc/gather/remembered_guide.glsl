// Where light came from at the points of a tile of 8 x 8 in the picture's grid, by direction: what guides the rays to come.
// The C++ side: remembered_guide.h.
#ifndef LANTHORN_EMC_REMEMBERED_GUIDE_GLSL
#define LANTHORN_EMC_REMEMBERED_GUIDE_GLSL

#include "engine/render/octahedral.glsl"

const int kGuideSide = 8;  // cells a side of the octahedron's square
const uint kGuideCells = uint(kGuideSide * kGuideSide);
const float kGuideUnits = 64.0;  // that the tile's mean, squared, is counted as

// `row`: points of the grid.
uint guide_tile(uint key, uint row) { return key / row / 8u * ((row + 7u) / 8u) + key % row / 8u; }

uint guide_cell(uint tile, vec3 d) {
    ivec2 c = clamp(ivec2((octahedral_encode(d) * 0.5 + 0.5) * float(kGuideSide)), ivec2(0), ivec2(kGuideSide - 1));
    return tile * kGuideCells + uint(c.y * kGuideSide + c.x);
}

#endif
