#version 450 core
// Lists what the rays of each point of the picture have met, point by point.
layout(local_size_x = 64) in;

#include "remembered.glsl"

layout(std430, binding = 2) writeonly buffer Served { uint served[]; };

uniform usamplerBuffer remembered;
uniform usamplerBuffer cells;
uniform usamplerBuffer offsets;

void main() {
    uint entry = work_item();
    if (entry >= entry_count()) return;
    uint id = met(texelFetch(remembered, int(entry)).r);
    uvec2 cell = texelFetch(cells, int(entry)).rg;
    if (cell.x == kNoPoint || id == kNoRay) return;
    served[texelFetch(offsets, int(cell.x)).r + cell.y] = id;
}
