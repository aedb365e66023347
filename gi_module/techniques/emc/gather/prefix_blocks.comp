#version 450 core
// The sum of each block of counts.
#include "prefix_sums.glsl"

layout(std430, binding = 2) writeonly buffer Blocks { uint blocks[]; };

void main() {
    shared_sums[gl_LocalInvocationID.x] = own_sum();
    barrier();
    if (gl_LocalInvocationID.x != 0u) return;
    uint sum = 0u;
    for (int k = 0; k < 256; ++k) sum += shared_sums[k];
    blocks[gl_WorkGroupID.x] = sum;
}
