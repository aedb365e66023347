#version 450 core
// The rays of the listed entries through the environment maps: which lit texel each meets. MAPS says whom a ray asks.
//   ONE: one map; those that it cannot settle are listed for the next dispatch
//   ALL: every map, one after the other
//   EACH: an invocation a map (z); what the nearest hit is, and of which map, is kept for a dispatch of
//   NEAREST: that map again
//   NOBODY: nothing is kept yet
#define ONE 1
#define ALL 2
#define EACH 3
#define NEAREST 4
#define NOBODY 5
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "remembered.glsl"
#if MAPS == ONE || MAPS == ALL
#include "entry_list.glsl"
#else
layout(std430, binding = 7) buffer Nearest { uint nearest_header[4]; uint nearest[]; };  // by item of the list
#endif
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

// What EACH keeps of a map's answer; the least counts. A map that has seen all of the ray before its hit (or its end) knows: the first
// of those that see its start from its side, else the first. Of the others, the nearest hit, to 17 bits of its distance.
const uint kNoHit = 0xffffffffu;
const uint kMost = 64u;  // maps
uint answer_of(int slot, MapHit hit, bool sees_start) {
    if (hit.certain) return uint(slot) + (sees_start ? 0u : kMost);
    return hit.t < 0.0 ? kNoHit : 0x80000000u | (floatBitsToUint(hit.t) >> 1u & ~(kMost - 1u)) | uint(slot);
}
int slot_of(uint answer) { return int(answer % kMost); }

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
#if MAPS == NOBODY
    nearest[item] = kNoHit;
#else
    uint entry = list[item];
    vec4 start = texelFetch(starts, start_of(entry));
    vec3 n = point_normal(start);
    vec3 direction = unpack_direction(texelFetch(directions, int(entry)).x);
    vec3 origin = start.xyz + n * origin_offset();
#if MAPS == EACH
    int slot = int(gl_WorkGroupID.z);
    if (!slot_in_use(slot, 0.0)) return;
    MapHit hit = march(slot, origin, direction, ray_start(), scene_exit(origin, direction));
    atomicMin(nearest[item], answer_of(slot, hit, sees_side(slot, origin, n)));
#elif MAPS == NEAREST
    uint answer = nearest[item];
    int slot = slot_of(answer);
    MapHit hit;
    hit.t = -1.0;
    if (answer != kNoHit) hit = march(slot, origin, direction, ray_start(), scene_exit(origin, direction));
    bool found = hit.t >= 0.0;
    texels[entry] = meets(texels[entry], found ? lit_place_of(origin + direction * hit.t, direction, hit.normal) : kUnknown);
    flights[2u * entry + 1u] = floatBitsToUint(found ? hit.t : 0.0);
#else
    int hint = listed != 0 ? int(met(texels[entry])) : sharpest_map(start.xyz, n);
    bool settled = true;
#if MAPS == ONE
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
#endif
#endif
}
