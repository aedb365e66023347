#version 450 core
// Which dispatches of a splat program have something to do: each works off `run` entries of the tiles' lists (splat_runs.h).
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/splat/splat_tiles.glsl"

layout(std430, binding = 0) writeonly buffer Dispatches { uint groups[]; };  // three a dispatch
uniform int dispatch_count;
uniform int run;
uniform ivec2 blocks;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= dispatch_count) return;
    bool needed = i == 0 || uint(i * run) < longest_list;
    groups[3 * i] = needed ? uint(blocks.x) : 0u;
    groups[3 * i + 1] = needed ? uint(blocks.y) : 0u;
    groups[3 * i + 2] = 1u;
}
