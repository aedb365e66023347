#version 450 core
// Empties the places of each point's starts: one that has been given away since they were counted stays empty.
layout(local_size_x = 256) in;

#include "remembered.glsl"

layout(std430, binding = 2) writeonly buffer Served { uint served[]; };

uniform usamplerBuffer offsets;
uniform usamplerBuffer counts;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint first = texelFetch(offsets, int(key)).r;
    uint end = first + texelFetch(counts, int(key)).r;
    for (uint i = first; i < end; ++i) served[i] = kNoPoint;
}
