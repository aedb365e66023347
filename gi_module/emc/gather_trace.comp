#version 450 core
// Rays from surface points through the environment maps: which lit texel each meets. ONE_MAP 1: each ray asks one map; those that
// it cannot settle are listed for the next dispatch. ONE_MAP 0: each asks every map. `listed`: the rays are those of a list.
layout(local_size_x = 64) in;

#include "intersection.glsl"
#include "lit_maps.glsl"
#include "point_lists.glsl"
#include "engine/render/random.glsl"
#include "scatter.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) buffer Hits { uint hits[]; };  // by slot, ray and point; until it is settled: the map to ask next
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
layout(std430, binding = 7) buffer Unsettled { uint unsettled_count; uint unsettled_groups[3]; uint unsettled[]; };

uniform usamplerBuffer lit_index;
uniform samplerBuffer lit_points;
uniform int listed;
uniform int rays;       // a point and frame
uniform int frame;      // of those remembered, 0..kRemembered-1
uniform int capacity;   // of the list of points
uniform int row;        // points a row of keys: of the picture's grid, or of a map's face
uniform uint seed;

const uint kRemembered = 16u;  // RememberedHits::kFrames

// The map to ask first: of those that see the point, the one that shows it sharpest.
int sharpest_map(vec3 x, vec3 n) {
    int best = 0;
    float most = 0.0;
    for (int s = 0; s < map_count; ++s) {
        float w = sharpness(x - map_centres[s].xyz, n);
        bool better = w > most && slot_in_use(s, 0.0) && sees(s, x + n * origin_offset());
        best = better ? s : best;
        most = better ? w : most;
    }
    return best;
}

// Whether the lit texel with this number + 1 shows the surface of a point `o` from the map's centre.
bool shows(uint number, vec3 x, vec3 o, vec3 n) {
    vec4 point = texelFetch(lit_points, max(int(number) - 1, 0));
    vec3 m = point_normal(point);
    return number != 0u && dot(m, n) > kLeastLitCosine && abs(dot(x - point.xyz, m)) < lit_tolerance(o);
}

// The lit texel of a point: of the sharpest map that has one. At rims, where the nearest texels show what lies beside, the
// nearest one around them on the same surface.
uint lit_texel_of(vec3 x, vec3 n) {
    float most = 0.0;
    uint found = 0u;
    for (int s = 0; s < map_count; ++s) {
        vec3 o = x - map_centres[s].xyz;
        float w = sharpness(o, n);
        if (w > most && slot_in_use(s, 0.0)) {
            uint number = texelFetch(lit_index, lit_place(lit_texel(s, o))).r;
            bool fits = shows(number, x, o, n);
            most = fits ? w : most;
            found = fits ? number : found;
        }
    }
    int s = 0;
    while (s < map_count && found == 0u) {
        vec3 o = x - map_centres[s].xyz;
        if (slot_in_use(s, 0.0) && dot(o, n) < 0.0) {
            ivec3 p = lit_texel(s, o);
            int k = 0;
            while (k < 9 && found == 0u) {
                ivec3 q = ivec3(clamp(p.xy + ivec2(k % 3, k / 3) - 1, ivec2(0), ivec2(lit_resolution - 1)), p.z);
                uint number = texelFetch(lit_index, lit_place(q)).r;
                found = shows(number, x, o, n) ? number : 0u;
                ++k;
            }
        }
        ++s;
    }
    return found == 0u ? kUnknown : found - 1u;
}

// Place of a point in its tile of 8 x 8: near ones far apart (Bayer 1973).
uint rank_in_tile(uvec2 p) {
    uint rank = 0u;
    for (uint b = 0u; b < 3u; ++b) {
        rank = (rank << 2u) | ((((p.x ^ p.y) >> b) & 1u) << 1u) | ((p.y >> b) & 1u);
    }
    return rank;
}

// Two low-discrepancy numbers (R2, Roberts 2018) of the j-th ray of this frame: each point has its stretch of the sequence, by
// its rank, each tile a shift of its own.
vec2 ray_numbers(uint key, uint j) {
    uvec2 p = uvec2(key % uint(row), key / uint(row));
    uint tile = p.y / 8u * ((uint(row) + 7u) / 8u) + p.x / 8u;
    uint n = (rank_in_tile(p & 7u) * kRemembered + uint(frame)) * uint(rays) + j + 1u;
    uvec2 u = n * uvec2(3242174889u, 2447445414u) + pcg4d(uvec4(seed, tile, 31u, 37u)).xy;
    return vec2(u >> 8u) * (1.0 / 16777216.0);
}

void main() {
    uint item = work_item();
    uint ray = item;
    if (item >= (listed != 0 ? listed_count : point_count * uint(rays))) return;
    if (listed != 0) ray = list[item];
    uint i = ray % point_count;
    uint j = ray / point_count;
    uint place = (uint(frame) * uint(rays) + j) * uint(capacity) + i;
    uint key = keys[i];
    if (key == kNoPoint) {
        hits[place] = kUnknown;
        return;
    }
    vec4 point = points[i];
    vec3 n = point_normal(point);
    vec3 direction = cosine_direction(n, ray_numbers(key, j));
    vec3 origin = point.xyz + n * origin_offset();
    int hint = listed != 0 ? int(hits[place]) : sharpest_map(point.xyz, n);
    bool settled = true;
#if ONE_MAP
    SceneHit hit = intersect_next(origin, direction, ray_start(), hint, 0.0, settled);
    if (!settled) {
        hits[place] = uint(hint);
        uint at = atomicAdd(unsettled_count, 1u);
        unsettled[at] = ray;
        uint group = at / 64u;
        atomicMax(unsettled_groups[0], min(group + 1u, kRow));
        atomicMax(unsettled_groups[1], group / kRow + 1u);
        return;
    }
    uint nothing = kMiss;
#else
    SceneHit hit = intersect_all(origin, direction, ray_start(), hint, 0.0);
    uint nothing = kUnknown;
#endif
    hits[place] = hit.found ? lit_texel_of(hit.position, hit.normal) : nothing;
}
