#version 450 core
// After something has moved: rays that it may have crossed are stale, and listed; the others are listed apart if a lit texel
// shows something else than what they met, to be looked up again (remembered_again.comp): a software rasteriser runs, for every
// ray, what a few rays need. An invocation does RAYS rays of a start, which has RUNS times as many (remembered_there.comp).
// IN_PICTURE 0: rays of points of the lit maps that are no more are forgotten.
layout(local_size_x = 256) in;

#include "remembered_verify.glsl"
#include "entry_list.glsl"

#if !IN_PICTURE
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
#endif
layout(std430, binding = 5) readonly buffer There { uint there_count; uint there_groups[3]; uint there[]; };
layout(std430, binding = 6) buffer Stale { uint stale_count; uint stale_groups[3]; uint stale_list[]; };

uniform bool limbs_follow;  // remembered_limbs.comp will look closer at what is listed
#if !IN_PICTURE
uniform usamplerBuffer key_index;  // by key: number of its point + 1
uniform samplerBuffer points;      // by number

bool starts_at_a_point(vec4 start, uint key) {
    uint number = texelFetch(key_index, int(key)).r;
    vec4 point = texelFetch(points, max(int(number) - 1, 0));
    vec3 off = start.xyz - point.xyz;
    // Closer than rays start off their surfaces (scatter.glsl).
    return number != 0u && floatBitsToUint(start.w) == floatBitsToUint(point.w) && dot(off, off) < 4e-10 * local_length * local_length;
}
#endif

void main() {
    uint item = work_item();
    if (item >= there_count) return;
    uint first_ray = there[item] % RUNS * RAYS;
    int at = int(there[item] / RUNS);
    uint slot = uint((float(at) + 0.5) / float(capacity));
    // A float may be off by one where there are more than 2^24 starts.
    if (slot * uint(capacity) > uint(at)) --slot;
    if (uint(at) - slot * uint(capacity) >= uint(capacity)) ++slot;
    uint key = uint(at) - slot * uint(capacity);
    vec4 start = texelFetch(starts, at);
#if IN_PICTURE
    bool holds = true;
#else
    bool holds = starts_at_a_point(start, key);
#endif
    bool if_inside = limbs_follow || inside_is_stale(at, slot);
    uint stale_rays = 0u;
    uint rays_to_look_up = 0u;
    for (uint j = 0u; j < RAYS; ++j) {
        uint entry = entry_of(slot, min(first_ray + j, uint(rays) - 1u), key);
        uint before = texelFetch(remembered, int(entry)).r;
        uint id = met(before);
        bool is_there = id != kNoRay && first_ray + j < uint(rays);
        uvec2 flight = texelFetch(flights, int(entry)).rg;
        float l = uintBitsToFloat(flight.y);
        bool stale = is_there && holds && ((before & kStale) != 0u || movers_make_stale(start.xyz, unpack_direction(flight.x), l, if_inside));
        bool look = is_looked_up(id, slot, l == 0.0);
        stale_rays |= stale ? 1u << j : 0u;
        rays_to_look_up |= is_there && holds && look && !stale ? 1u << j : 0u;
#if !IN_PICTURE
        if (is_there && !holds) texels[entry] = kNoRay;
#endif
    }
    if (stale_rays != 0u) {
        uint first;
        TAKE_PLACES(stale_count, uint(bitCount(stale_rays)), first)
        uint next = first;
        for (uint j = 0u; j < RAYS; ++j) {
            if ((stale_rays >> j & 1u) != 0u) stale_list[next++] = entry_of(slot, first_ray + j, key);
        }
        COUNT_GROUPS(stale_groups, first, next - 1u, 256u)
    }
    if (rays_to_look_up != 0u) {
        uint next = append_entries(uint(bitCount(rays_to_look_up)));
        for (uint j = 0u; j < RAYS; ++j) {
            if ((rays_to_look_up >> j & 1u) != 0u) appended[next++] = entry_of(slot, first_ray + j, key);
        }
    }
}
