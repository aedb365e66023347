#version 450 core
// Lists the pixels whose luma differs from a neighbour's as at an edge.
#include "fxaa.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

const float kLeastContrast = 0.125;  // of the brightest around
const float kLeastStep = 0.03;       // eight levels of 256: in the dark nobody sees less

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(picture, 0);
    if (any(greaterThanEqual(p, size))) return;
    float here = luma_at(p);
    vec4 around = vec4(luma_at(p + ivec2(0, 1)), luma_at(p - ivec2(0, 1)), luma_at(p + ivec2(1, 0)), luma_at(p - ivec2(1, 0)));
    float most = max(here, max(max(around.x, around.y), max(around.z, around.w)));
    float least = min(here, min(min(around.x, around.y), min(around.z, around.w)));
    if (most - least < max(kLeastStep, most * kLeastContrast)) return;
    uint i = atomicAdd(edges.count, 1u);
    edges.pixels[i] = uint(p.x + size.x * p.y);
    if (i % kSmoothGroup != 0u) return;  // who begins a group tells of it
    uint group = i / kSmoothGroup;
    atomicMax(edges.groups_x, min(group + 1u, kRow));
    atomicMax(edges.groups_y, group / kRow + 1u);
}
