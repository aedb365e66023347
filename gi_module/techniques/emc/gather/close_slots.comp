#version 450 core
// Which slots of close hits are still somebody's: those are listed, to be lit where their ray ends now, whatever carries it along.
// The others are free for the next frame.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"

layout(std430, binding = 10) buffer ClosePoints { vec4 close_points[]; };
layout(std430, binding = 12) buffer CloseFree { uint close_taken; uint close_free_count; uint close_free[]; };

uniform usamplerBuffer remembered;    // texels
uniform usamplerBuffer close_owners;  // entry, lit texel
uniform samplerBuffer starts;
uniform usamplerBuffer flights;       // direction, distance
uniform float origin_offset;          // m, along the normal
uniform int close_first;
uniform int slots;
uniform int entries;

void main() {
    int slot = int(work_item());
    if (slot >= slots) return;
    uint owner = texelFetch(close_owners, slot).x;
    uint entry = min(owner, uint(entries) - 1u);
    bool taken = owner < uint(entries) && met(texelFetch(remembered, int(entry)).r) == uint(close_first + slot);
    if (taken) {
        vec4 start = texelFetch(starts, start_of(entry));
        uvec2 flight = texelFetch(flights, int(entry)).rg;
        close_points[slot].xyz = start.xyz + point_normal(start) * origin_offset + unpack_direction(flight.x) * uintBitsToFloat(flight.y);
        list_entry(uint(slot));
    }
    if (!taken) close_free[atomicAdd(close_free_count, 1u)] = uint(slot);
}
