#version 450 core
// The starts that hold rays, listed RUNS times each. A place in the list costs more than a look: an invocation does KEYS keys.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"

uniform usamplerBuffer remembered;  // texels

void main() {
    uint first = item_key() * KEYS;
    uint slot = item_row();
    uint there = 0u;
    for (uint k = 0u; k < KEYS; ++k) {
        uint key = first + k;
        uint ray = texelFetch(remembered, int(entry_of(slot, 0u, min(key, uint(capacity) - 1u)))).r;
        there |= key < uint(capacity) && met(ray) != kNoRay ? 1u << k : 0u;
    }
    if (there == 0u) return;
    uint next = append_entries(uint(bitCount(there)) * RUNS);
    for (uint k = 0u; k < KEYS; ++k) {
        if ((there >> k & 1u) != 0u) {
            for (uint run = 0u; run < RUNS; ++run) appended[next++] = start_of(slot, first + k) * RUNS + run;
        }
    }
}
