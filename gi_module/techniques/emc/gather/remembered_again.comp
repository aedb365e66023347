#version 450 core
// Looks up again what the listed rays have met, in the lit texels as they are now.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "remembered.glsl"

layout(std430, binding = 4) buffer Texels { uint texels[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform usamplerBuffer flights;  // direction, distance

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint entry = list[item];
    uint before = texels[entry];
    uint id = met(before);
    uvec2 flight = texelFetch(flights, int(entry)).rg;
    vec3 d = unpack_direction(flight.x);
    vec3 p = texelFetch(starts, start_of(entry)).xyz + d * uintBitsToFloat(flight.y);
    vec3 m;
    int slot = id < kNoRay ? int(id) / (6 * lit_resolution * lit_resolution) : 0;
    vec3 o = p - map_centres[slot].xyz;
    bool fits = id < kNoRay && met_there(int(id), p, o, d, vec3(0.0), m);
    texels[entry] = meets(before, fits ? id : lit_place_of(p, d, vec3(0.0)));
}
