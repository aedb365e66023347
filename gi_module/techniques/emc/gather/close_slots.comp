#version 450 core
// Which slots of close hits are still somebody's: those are listed, to be lit where their ray ends now, whatever carries it along.
// The others are free for the next frame.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"

layout(std430, binding = 10) buffer ClosePoints { vec4 close_points[]; };
#include "close_free.glsl"

uniform usamplerBuffer remembered;    // texels
uniform usamplerBuffer close_owners;  // entry, lit texel
uniform samplerBuffer starts;
uniform usamplerBuffer flights;       // direction, distance
uniform float origin_offset;          // m, along the normal
uniform int close_first;
uniform int slots;
uniform int entries;

const int kAtOnce = 8;  // slots that an invocation does: a place in a list costs more than a look

void main() {
    int first = kAtOnce * int(work_item());
    if (first >= slots) return;
    uint taken = 0u;
    for (int k = 0; k < kAtOnce; ++k) {
        uint owner = texelFetch(close_owners, first + k).x;
        uint word = texelFetch(remembered, int(min(owner, uint(entries) - 1u))).r;
        taken |= owner < uint(entries) && met(word) == uint(close_first + first + k) ? 1u << k : 0u;
    }
    uint free = ~taken & ((1u << kAtOnce) - 1u);
    uint next_free = atomicAdd(close_free_count, uint(bitCount(free)));
    while (free != 0u) {
        close_free[next_free++] = uint(first + findLSB(free));
        free &= free - 1u;
    }
    uint next = taken != 0u ? append_entries(uint(bitCount(taken))) : 0u;
    while (taken != 0u) {
        int slot = first + findLSB(taken);
        taken &= taken - 1u;
        uint entry = texelFetch(close_owners, slot).x;
        vec4 start = texelFetch(starts, start_of(entry));
        uvec2 flight = texelFetch(flights, int(entry)).rg;
        close_points[slot].xyz = start.xyz + point_normal(start) * origin_offset + unpack_direction(flight.x) * uintBitsToFloat(flight.y);
        appended[next++] = uint(slot);
    }
}
