#version 450 core
// The rays that points shoot in this frame. Each slot of a point has the same directions always, and what was shot from there is
// not shot again: of the slots from this frame's on, the first that holds rays from elsewhere, or none. A point that knows little
// fills several. While the view changes, points that enough starts serve shoot nothing, and the others take slots first that no
// point is in need of.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"
#include "engine/render/random.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 2) writeonly buffer Starts { vec4 starts[]; };
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uvec2 flights[]; };
#if IN_PICTURE
layout(std430, binding = 1) buffer Counts { uint counts[]; };
layout(std430, binding = 6) writeonly buffer Cells { uvec2 cells[]; };
#endif

uniform usamplerBuffer remembered;
uniform samplerBuffer started;
uniform samplerBuffer points;   // by number
uniform usamplerBuffer keys;
uniform int frame;       // 0 .. kRemembered - 1
uniform int row;         // points a row of keys: of the picture's grid, or of a map's face
uniform uint seed;
uniform int pass;        // of rays that are not remembered, from 0
#if IN_PICTURE
uniform bool view_changes;
uniform usamplerBuffer cells_before;   // as the frame found them, whatever others do now
uniform usamplerBuffer counts_before;
#endif
uniform float same_place;  // m: rays from points as near as that are the same

const uint kStretch = kRemembered > 1u ? kRemembered : 65536u;  // of the sequence, that a point has: slots, or passes
const uint kSlotsAtOnce = 4u;  // of a point that has filled less than a quarter

// Place of a point in its tile of 8 x 8: near ones far apart (Bayer 1973).
uint rank_in_tile(uvec2 p) {
    uint rank = 0u;
    for (uint b = 0u; b < 3u; ++b) {
        rank = (rank << 2u) | ((((p.x ^ p.y) >> b) & 1u) << 1u) | ((p.y >> b) & 1u);
    }
    return rank;
}

// Two low-discrepancy numbers (R2, Roberts 2018) of the j-th ray of a slot: each point has its stretch of the sequence, by its
// rank, each tile a shift of its own.
vec2 ray_numbers(uint key, uint slot, uint j) {
    uvec2 p = uvec2(key % uint(row), key / uint(row));
    uint tile = p.y / 8u * ((uint(row) + 7u) / 8u) + p.x / 8u;
    uint n = (rank_in_tile(p & 7u) * kStretch + slot + uint(pass)) * uint(rays) + j + 1u;
    uvec2 u = n * uvec2(3242174889u, 2447445414u) + pcg4d(uvec4(seed, tile, 31u, 37u)).xy;
    return vec2(u >> 8u) * (1.0 / 16777216.0);
}

bool shot_from(uint slot, uint key, vec4 point) {
    vec4 start = texelFetch(started, int(start_of(slot, key)));
    return met(texelFetch(remembered, int(entry_of(slot, 0u, key))).r) != kNoRay && floatBitsToUint(start.w) == floatBitsToUint(point.w) &&
           distance(start.xyz, point.xyz) < same_place;
}

#if IN_PICTURE
// Whether the start there serves a point that has no more than it should.
bool needed(uint slot, uint key) {
    uint cell = texelFetch(cells_before, int(start_of(slot, key))).r;
    return cell != kNoPoint && texelFetch(counts_before, int(cell)).r <= kRemembered;
}
#endif

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    uint key = texelFetch(keys, int(i)).r;
    if (key == kNoPoint) return;
    vec4 point = texelFetch(points, int(i));
    vec3 n = point_normal(point);
    uint taken = 0u;  // slots, a bit each
#if IN_PICTURE
    uint count = texelFetch(counts_before, int(key)).r;
    if (view_changes && count >= kRemembered) return;
    bool knows_little = 4u * count < kRemembered;
#else
    for (uint s = 0u; s < kRemembered; ++s) taken |= shot_from(s, key, point) ? 1u << s : 0u;
    bool knows_little = 4u * uint(bitCount(taken)) < kRemembered;
    if (taken == (1u << kRemembered) - 1u) return;
#endif
    uint wanted = knows_little ? kSlotsAtOnce : 1u;
    uint k = 0u;
    while (k < 2u * kRemembered && wanted > 0u) {
        uint slot = (uint(frame) + k) % kRemembered;
        bool first_round = k < kRemembered;
        ++k;
        if ((taken & (1u << slot)) != 0u) continue;
#if IN_PICTURE
        if (view_changes && first_round && needed(slot, key)) continue;
        if (shot_from(slot, key, point)) continue;
#endif
        --wanted;
        taken |= 1u << slot;
        starts[start_of(slot, key)] = point;
#if IN_PICTURE
        cells[start_of(slot, key)] = uvec2(key, atomicAdd(counts[key], 1u));
#endif
        for (uint j = 0u; j < uint(rays); ++j) {
            uint entry = entry_of(slot, j, key);
            // A stale ray that was there is on the list already; twice there, one would overwrite what the other goes by.
            bool is_listed = texelFetch(remembered, int(entry)).r == kListed;
            flights[entry] = uvec2(pack_direction(cosine_direction(n, ray_numbers(key, slot, j))), 0u);
            texels[entry] = kUnknown;
            if (!is_listed) list_entry(entry);
        }
    }
}
