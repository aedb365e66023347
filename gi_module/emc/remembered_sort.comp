#version 450 core
// Lists what the rays of each point of the picture have met, point by point.
layout(local_size_x = 256) in;

#include "remembered.glsl"

layout(std430, binding = 2) writeonly buffer Served { uint served[]; };

uniform usamplerBuffer remembered;
uniform usamplerBuffer cells;
uniform usamplerBuffer offsets;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint slot = item_row();
    uint at = start_of(slot, key);
    uvec2 cell = texelFetch(cells, int(at)).rg;
    if (cell.x == kNoPoint) return;
    uint first = (texelFetch(offsets, int(cell.x)).r + (cell.y & ~kCarried)) * uint(rays);
    for (uint j = 0u; j < uint(rays); ++j) served[first + j] = met(texelFetch(remembered, int(entry_of(slot, j, key))).r);
}
