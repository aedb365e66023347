#version 450 core
// Where the rays of the listed entries, traced outside of the maps, have arrived: looked up in the lit texels. FIRST 1: in the
// sharpest map, which has nearly all. 0: the items that were not found there, in all maps; a software rasteriser would look for
// every ray as long as for the worst of those beside it. CLOSE 1: hits that a lit texel is too wide for have a place of their own.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "remembered.glsl"
#include "engine/render/random.glsl"
#include "gi_module/techniques/emc/photons/scatter.glsl"
#include "gi_module/techniques/emc/photons/sky_places.glsl"
#if CLOSE
#include "close_hits.glsl"
#endif
#if FIRST
#include "entry_list.glsl"
#endif

layout(std430, binding = 4) buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uint flights[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

#if !FIRST
layout(std430, binding = 7) readonly buffer Left { uint left_count; uint left_groups[3]; uint left[]; };  // items
#endif

uniform samplerBuffer starts;
uniform usamplerBuffer directions;  // by entry: flights
uniform usamplerBuffer arrivals;    // by item: bits of the distance, 0: nothing met; octahedral normal, towards the origin; albedo

void main() {
    uint item = work_item();
#if FIRST
    if (item >= listed_count) return;
#else
    if (item >= left_count) return;
    item = left[item];
#endif
    uint entry = list[item];
    uvec3 arrival = texelFetch(arrivals, int(item)).rgb;
    vec4 start = texelFetch(starts, start_of(entry));
    float t = uintBitsToFloat(arrival.x);
    vec3 origin = start.xyz + point_normal(start) * origin_offset();
    vec3 direction = unpack_direction(texelFetch(directions, int(entry)).x);
    vec3 x = origin + direction * t;
    vec3 n = octahedral_decode(unpackSnorm2x16(arrival.y));
#if FIRST
    uint found = t > 0.0 ? sharpest_place_of(x, direction, n) : sky_place_of(direction);
    if (found == kUnlit) list_entry(item);
#if CLOSE
    if (found < uint(sky_first)) found = closer_place(entry, found, x, n, t, arrival.z);
#endif
    texels[entry] = meets(texels[entry], found);
    flights[2u * entry + 1u] = arrival.x;
#else
    uint found = lit_place_of(x, direction, n);
#if CLOSE
    found = closer_place(entry, found, x, n, t, arrival.z);
#endif
    texels[entry] = meets(texels[entry], found);
#endif
}
