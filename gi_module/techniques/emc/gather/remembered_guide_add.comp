#version 450 core
// Adds what remembered rays have met to the guides of the tiles that their starts serve: the square of its luminance, since rays
// had best be spread by the root of that. Sums of whole numbers: the same in any order.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "remembered_guide.glsl"
#include "gather_surface.glsl"

layout(std430, binding = 2) buffer Guide { uvec2 guide[]; };  // by cell of a tile: squares, rays

uniform usamplerBuffer remembered;
uniform usamplerBuffer flights;
uniform usamplerBuffer cells;     // by start: the point it serves
uniform samplerBuffer radiosity;  // by place, lux; a < 0: not lit
uniform samplerBuffer means;      // by tile, lux
uniform int row;
uniform int slot;  // whose rays are added; -1: all slots'

const float kBrightest = 64.0;  // of the mean: so that sums of 4096 rays fit

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint of = slot < 0 ? item_row() : uint(slot);
    uint cell = texelFetch(cells, int(start_of(of, key))).r;
    uint tile = cell == kNoPoint ? 0u : guide_tile(cell, uint(row));
    float mean = texelFetch(means, int(tile)).r;
    if (cell == kNoPoint || !(mean > 0.0)) return;
    for (uint j = 0u; j < uint(rays); ++j) {
        int entry = int(entry_of(of, j, key));
        uint id = met(texelFetch(remembered, entry).r);
        vec4 b = texelFetch(radiosity, id < kNoRay ? int(id) : 0);
        bool lit = id < kNoRay && b.a >= 0.0;
        if (!lit && id != kUnlit) continue;
        float y = lit ? min(luminance(b.rgb) / mean, kBrightest) : 0.0;
        uint at = guide_cell(tile, unpack_direction(texelFetch(flights, entry).r));
        atomicAdd(guide[at].x, uint(y * y * kGuideUnits + 0.5));
        atomicAdd(guide[at].y, 1u);
    }
}
