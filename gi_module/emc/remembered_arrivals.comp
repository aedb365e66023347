#version 450 core
// Where the rays of the listed entries, traced outside of the maps, have arrived: looked up in the lit texels.
layout(local_size_x = 256) in;

#include "intersection.glsl"
#include "lit_lookup.glsl"
#include "remembered.glsl"
#include "engine/render/random.glsl"
#include "scatter.glsl"
#include "sky_places.glsl"

layout(std430, binding = 4) buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uint flights[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform usamplerBuffer directions;  // by entry: flights
uniform usamplerBuffer arrivals;    // by item: bits of the distance, 0: nothing met; octahedral normal, towards the origin

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint entry = list[item];
    uvec2 arrival = texelFetch(arrivals, int(item)).rg;
    vec4 start = texelFetch(starts, start_of(entry));
    float t = uintBitsToFloat(arrival.x);
    vec3 origin = start.xyz + point_normal(start) * origin_offset();
    vec3 direction = unpack_direction(texelFetch(directions, int(entry)).x);
    vec3 x = origin + direction * t;
    vec3 n = octahedral_decode(unpackSnorm2x16(arrival.y));
    texels[entry] = meets(texels[entry], t > 0.0 ? lit_place_of(x, direction, n) : sky_place_of(direction));
    flights[2u * entry + 1u] = arrival.x;
}
