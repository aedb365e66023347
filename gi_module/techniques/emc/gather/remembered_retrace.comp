#version 450 core
// Lists the rays that are stale, to be traced again from where they started: all, or as large a share of them as `budget` allows.
// The others are marked, for the frames to come.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"
#include "engine/render/random.glsl"

layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform usamplerBuffer remembered;
uniform bool just_found;  // by this frame; else those that are marked are left
uniform int budget;
uniform float least_share;
uniform int frame;

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint entry = list[item];
    uint id = texelFetch(remembered, int(entry)).r;
    if (met(id) == kNoRay || !(just_found || (id & kStale) != 0u)) return;
    float chance = max(float(budget) / float(max(listed_count, 1u)), least_share);
    float u = float(pcg4d(uvec4(entry, uint(frame), 41u, 43u)).x >> 8u) * (1.0 / 16777216.0);
    if (u < chance) {
        list_entry(entry);
        texels[entry] = meets(id, kListed);
    } else {
        texels[entry] = id | kStale;
    }
}
