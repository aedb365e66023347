#version 450 core
// The rays that points shoot in this frame. Each slot of a point has the same directions always, and what was shot from there is
// not shot again: of the slots from this frame's on, the first that holds rays from elsewhere, or none. A point that knows little
// fills several. While the view changes, points that enough starts serve shoot nothing, and the others take slots first that no
// point is in need of.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"
#include "ray_numbers.glsl"
#if IN_PICTURE
#include "remembered_guide.glsl"
#endif

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 2) writeonly buffer Starts { vec4 starts[]; };
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uvec2 flights[]; };
#if IN_PICTURE
layout(std430, binding = 1) buffer Counts { uint counts[]; };
layout(std430, binding = 3) buffer Guided { uint guided_count; uint guided_groups[3]; uint guided[]; };  // starts
layout(std430, binding = 6) writeonly buffer Cells { uvec2 cells[]; };
#endif

uniform usamplerBuffer remembered;
uniform samplerBuffer started;
uniform samplerBuffer points;   // by number
uniform usamplerBuffer keys;
uniform int frame;       // 0 .. slots_in_use - 1
#if IN_PICTURE
uniform uint slots_in_use;             // of kRemembered
uniform bool view_changes;
uniform usamplerBuffer cells_before;   // as the frame found them, whatever others do now
uniform usamplerBuffer counts_before;
uniform samplerBuffer guide_means;
uniform bool has_guides;
uniform bool shoot_again;              // also what this frame has shot, now that something guides it
uniform uint enough;                   // starts, for a point while the view changes
#endif
#if !IN_PICTURE
const uint slots_in_use = kRemembered;
#endif
uniform float same_place;  // m: rays from points as near as that are the same

uniform uint slots_at_once;  // of a point that has filled less than a quarter

bool shot_from(uint slot, uint key, vec4 point) {
    vec4 start = texelFetch(started, int(start_of(slot, key)));
    return met(texelFetch(remembered, int(entry_of(slot, 0u, key))).r) != kNoRay && floatBitsToUint(start.w) == floatBitsToUint(point.w) &&
           distance(start.xyz, point.xyz) < same_place;
}

#if IN_PICTURE
// To have its rays guided, by remembered_guide_rays.comp.
void list_guided(uint start) {
    uint at;
    TAKE_PLACES(guided_count, 1u, at)
    guided[at] = start;
    COUNT_GROUPS(guided_groups, at, at, 256u)
}

// Whether the start there serves a point that has no more than it should.
bool needed(uint slot, uint key) {
    uint cell = texelFetch(cells_before, int(start_of(slot, key))).r;
    return cell != kNoPoint && texelFetch(counts_before, int(cell)).r <= enough;
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
    if (view_changes && count >= enough) return;
    bool knows_little = 4u * count < slots_in_use;
    bool has_guide = has_guides && texelFetch(guide_means, int(guide_tile(key, uint(row)))).r > 0.0;
#else
    for (uint s = 0u; s < kRemembered; ++s) taken |= shot_from(s, key, point) ? 1u << s : 0u;
    bool knows_little = 4u * uint(bitCount(taken)) < kRemembered;
    if (taken == (1u << kRemembered) - 1u) return;
#endif
    uint wanted = knows_little ? slots_at_once : 1u;
    // What is in need is passed over in a first round.
#if IN_PICTURE
    uint rounds = view_changes ? 2u : 1u;
#else
    const uint rounds = 1u;
#endif
    // What is written follows apart: a software rasteriser runs a loop's body for as many slots as any point looks at.
    uint chosen = 0u;
    uint k = 0u;
    while (k < rounds * slots_in_use && wanted > 0u) {
        uint slot = (uint(frame) + k) % slots_in_use;
        bool is_free = ((taken | chosen) & (1u << slot)) == 0u;
#if IN_PICTURE
        bool is_passed_over = view_changes && k < slots_in_use && needed(slot, key);
        is_free = is_free && !is_passed_over && (shoot_again || !shot_from(slot, key, point));
#endif
        chosen |= is_free ? 1u << slot : 0u;
        wanted -= is_free ? 1u : 0u;
        ++k;
    }
    while (chosen != 0u) {
        uint slot = uint(findLSB(chosen));
        chosen &= chosen - 1u;
        uint at = start_of(slot, key);
#if IN_PICTURE
        bool is_own = shot_from(slot, key, point) && texelFetch(cells_before, int(at)).r == key;
        if (!is_own) cells[at] = uvec2(key, atomicAdd(counts[key], 1u));
        if (has_guide) list_guided(at);
#endif
        starts[at] = point;
        uint first = 0u;
        do {
            uint unlisted = 0u;  // a bit a ray, 32 at most
            uint end = min(uint(rays), first + 32u);
            for (uint j = first; j < end; ++j) {
                uint entry = entry_of(slot, j, key);
                // A stale ray that was there is on the list already; twice there, one would overwrite what the other goes by.
                unlisted |= met(texelFetch(remembered, int(entry)).r) == kListed ? 0u : 1u << (j - first);
                flights[entry] = uvec2(pack_direction(cosine_direction(n, ray_numbers(key, slot, j))), 0u);
                texels[entry] = kUnknown;
            }
            uint next = unlisted != 0u ? append_entries(uint(bitCount(unlisted))) : 0u;
            while (unlisted != 0u) {
                appended[next++] = entry_of(slot, first + uint(findLSB(unlisted)), key);
                unlisted &= unlisted - 1u;
            }
            first += 32u;
        } while (first < uint(rays));
    }
}
