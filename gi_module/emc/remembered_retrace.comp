#version 450 core
// Lists stale rays, to be traced again from where they started: all, or as large a share of them as `budget` allows.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"
#include "engine/render/random.glsl"

layout(std430, binding = 1) readonly buffer Stale { uint stale_count; };

uniform usamplerBuffer remembered;
uniform int budget;
uniform float least_share;
uniform int frame;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint entry = item_row() * uint(capacity) + key;
    uint id = texelFetch(remembered, int(entry)).r;
    if (id == met(id) || met(id) == kNoRay) return;
    float chance = max(float(budget) / float(max(stale_count, 1u)), least_share);
    float u = float(pcg4d(uvec4(entry, uint(frame), 41u, 43u)).x >> 8u) * (1.0 / 16777216.0);
    if (u < chance) list_entry(entry);
}
