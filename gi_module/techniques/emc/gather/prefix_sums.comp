#version 450 core
// The sum of the counts before each, behind prefix_blocks.comp.
#include "prefix_sums.glsl"

layout(std430, binding = 2) writeonly buffer Sums { uint sums[]; };

uniform usamplerBuffer blocks;

shared uint shared_blocks[256];

void main() {
    int own = int(gl_LocalInvocationID.x);
    shared_sums[own] = own_sum();
    uint of_blocks = 0u;
    for (int b = own; b < int(gl_WorkGroupID.x); b += 256) of_blocks += texelFetch(blocks, b).r;
    shared_blocks[own] = of_blocks;
    barrier();
    uint before = 0u;
    int earlier = min(int(gl_WorkGroupID.x), 256);
    for (int k = 0; k < earlier; ++k) before += shared_blocks[k];
    for (int k = 0; k < own; ++k) before += shared_sums[k];
    for (int i = own_first(); i < own_end(); ++i) {
        sums[i] = before;
        before += texelFetch(counts, i).r;
    }
}
