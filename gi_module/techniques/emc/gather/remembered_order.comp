#version 450 core
// Puts the starts of each point of the picture in ascending order, whatever order parallel invocations listed them in: what is
// summed in one order is the same sum, bit for bit. Places that were given away go to the end.
layout(local_size_x = 256) in;

#include "remembered.glsl"

layout(std430, binding = 2) buffer Served { uint served[]; };

uniform usamplerBuffer offsets;
uniform usamplerBuffer counts;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    int first = int(texelFetch(offsets, int(key)).r);
    int end = first + int(texelFetch(counts, int(key)).r);
    for (int i = first + 1; i < end; ++i) {
        uint start = served[i];
        int k = i;
        while (k > first && served[max(k - 1, first)] > start) {
            served[k] = served[k - 1];
            --k;
        }
        served[k] = start;
    }
}
