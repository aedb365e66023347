#version 450 core
// Of the rays that seem stale by boxes around whole figures, those that are by boxes around their limbs. The others are listed
// to be looked up again where a lit texel shows something else.
layout(local_size_x = 256) in;

#include "remembered_verify.glsl"
#include "entry_list.glsl"

layout(std430, binding = 5) buffer Stale { uint stale_count; uint stale_groups[3]; uint stale_list[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint entry = list[item];
    uint slot = entry / uint(rays * capacity);
    int at = start_of(entry);
    uint before = texelFetch(remembered, int(entry)).r;
    uint id = met(before);
    uvec2 flight = texelFetch(flights, int(entry)).rg;
    float l = uintBitsToFloat(flight.y);
    vec3 x = texelFetch(starts, at).xyz;
    bool stale = (before & kStale) != 0u || movers_make_stale(x, unpack_direction(flight.x), l, inside_is_stale(at, slot));
    if (stale) {
        uint place;
        TAKE_PLACES(stale_count, 1u, place)
        stale_list[place] = entry;
        COUNT_GROUPS(stale_groups, place, place, 256u)
    } else if (is_looked_up(id, slot, l == 0.0)) {
        list_entry(entry);
    }
}
