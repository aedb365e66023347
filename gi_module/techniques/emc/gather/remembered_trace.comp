#version 450 core
// The rays of the listed entries through the environment maps: which lit texel each meets. ONE_MAP 1: each ray asks one map;
// those that it cannot settle are listed for the next dispatch. ONE_MAP 0: each asks every map.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "remembered.glsl"
#include "entry_list.glsl"
#include "engine/render/random.glsl"
#include "gi_module/techniques/emc/photons/scatter.glsl"
#include "gi_module/techniques/emc/photons/sky_places.glsl"

layout(std430, binding = 4) buffer Texels { uint texels[]; };             // by entry; until it is settled: the map to ask next
layout(std430, binding = 5) writeonly buffer Flights { uint flights[]; };  // two by entry: direction, distance
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform usamplerBuffer directions;      // by entry: flights
uniform int listed;                     // 0: of the first round

// The map to ask first: of those that see the point, the one that shows it sharpest.
int sharpest_map(vec3 x, vec3 n) {
    int best = 0;
    float most = 0.0;
    for (int s = 0; s < map_count; ++s) {
        float w = sharpness(x - map_centres[s].xyz, n);
        bool better = w > most && slot_in_use(s, 0.0) && sees_side(s, x + n * origin_offset(), n);
        best = better ? s : best;
        most = better ? w : most;
    }
    return best;
}

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint entry = list[item];
    vec4 start = texelFetch(starts, start_of(entry));
    vec3 n = point_normal(start);
    vec3 direction = unpack_direction(texelFetch(directions, int(entry)).x);
    vec3 origin = start.xyz + n * origin_offset();
    int hint = listed != 0 ? int(met(texels[entry])) : sharpest_map(start.xyz, n);
    bool settled = true;
#if ONE_MAP
    SceneHit hit = intersect_next(origin, n, direction, ray_start(), hint, listed == 0, 0.0, settled);
    if (!settled) {
        texels[entry] = meets(texels[entry], uint(hint));
        list_entry(entry);
        return;
    }
    uint nothing = sky_place_of(direction);
#else
    SceneHit hit = intersect_all(origin, n, direction, ray_start(), hint, 0.0);
    uint nothing = kUnknown;
#endif
    texels[entry] = meets(texels[entry], hit.found ? lit_place_of(hit.position, direction, hit.normal) : nothing);
    flights[2u * entry + 1u] = floatBitsToUint(hit.found ? hit.t : 0.0);
}
