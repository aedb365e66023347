#version 450 core
// Lists the starts that serve each point of the picture, point by point.
layout(local_size_x = 256) in;

#include "remembered.glsl"

layout(std430, binding = 2) writeonly buffer Served { uint served[]; };

uniform usamplerBuffer cells;
uniform usamplerBuffer offsets;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint at = start_of(item_row(), key);
    uvec2 cell = texelFetch(cells, int(at)).rg;
    if (cell.x != kNoPoint) served[texelFetch(offsets, int(cell.x)).r + (cell.y & ~kCarried)] = at;
}
