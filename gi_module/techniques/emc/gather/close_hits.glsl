// Hits that a lit texel is too wide for, lit one by one. Needs lit_lookup.glsl and random.glsl. The C++ side: close_hits.h.
#ifndef LANTHORN_EMC_CLOSE_HITS_GLSL
#define LANTHORN_EMC_CLOSE_HITS_GLSL

layout(std430, binding = 10) writeonly buffer ClosePoints { vec4 close_points[]; };   // by slot: packed
layout(std430, binding = 11) writeonly buffer CloseOwners { uvec2 close_owners[]; };  // by slot: entry, lit texel or kUnlit or close_albedo()
#include "close_free.glsl"

uniform samplerBuffer lit_nearness;  // by place, a: a lit texel's width over its distance from a lamp
uniform samplerBuffer close_lamps;   // xyz
uniform int close_lamp_count;
uniform int close_first;             // the slots' first place
uniform int close_every_hit;         // 1: no lit texel is good enough, and what none shows goes by its own albedo

// Which lot of rays an entry is of: where there are fewer slots than hits that want one, some lots get all they want and others none.
uint close_lot(uint entry) { return pcg4d(uvec4(entry, 0u, 0u, 0u)).x % kCloseLots; }

const float kNearLamp = 1.0 / 6.0;     // nearness, from which on a texel's light is not that of each of its points
const float kNearContact = 1.0 / 24.0;  // the same for a ray that is shorter than kContact of its widths
const float kContact = 4.0;
// Of a ray, in the same widths: few rays meet a small thing from further off, and each would be a blotch of what it brings.
const float kFarthest = 16.0;

// Whether the surface that a lit texel shows ends beside it: then the texel's square holds other things than its middle. On a wide
// one the texel's mean has less noise than the light of single points.
bool ends_beside(int place) {
    ivec2 p = ivec2(place % lit_resolution, place / lit_resolution % lit_resolution);
    int face = place / (lit_resolution * lit_resolution);
    vec4 own = texelFetch(lit_points, place);
    vec3 n = point_normal(own);
    bool ends = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 q = clamp(p + (k < 2 ? ivec2(2 * k - 1, 0) : ivec2(0, 2 * k - 5)), ivec2(0), ivec2(lit_resolution - 1));
        vec4 point = texelFetch(lit_points, lit_place(ivec3(q, face)));
        float off = abs(dot(point.xyz - own.xyz, n));
        // Where another map is sharper nothing but the place is known.
        bool turns = is_lit(point) && dot(point_normal(point), n) < kLeastLitCosine;
        ends = ends || turns || off > 0.1 * distance(point.xyz, own.xyz);
    }
    return ends;
}

// What the entry's ray has met at x, of that albedo, in direction d after t metres: a slot of its own, or `found`, if that is as good or none is free.
// Few rays get past the first test: the loops are left at once where none does, which a software rasteriser does for no `if`.
uint closer_place(uint entry, uint found, vec3 x, vec3 n, float t, uint albedo) {
    bool is_lit = found < kNoRay;
    int map = is_lit ? int(found) / (6 * lit_resolution * lit_resolution) : 0;
    float width = 2.0 * distance(x, map_centres[map].xyz) / float(lit_resolution);
    float near = is_lit ? texelFetch(lit_nearness, int(found)).a : 0.0;
    bool every = close_every_hit != 0;
    bool looked = is_lit || every;
    while (!looked) {
        float r2 = 3.4e38;
        for (int s = 0; s < map_count; ++s) r2 = min(r2, dot(x - map_centres[s].xyz, x - map_centres[s].xyz));
        width = 2.0 * sqrt(r2) / float(lit_resolution);
        for (int i = 0; i < close_lamp_count; ++i) near = max(near, width / max(distance(texelFetch(close_lamps, i).xyz, x), 1e-20));
        looked = true;
    }
    bool is_short = is_lit && t < kContact * width;
    bool is_close = every || near > (is_short ? kNearContact : kNearLamp) && t <= kFarthest * width;
    uint without = every ? close_albedo(albedo) : kUnlit;
    uint place = found;
    while (is_close) {
        bool alone = every || !is_lit || is_short || ends_beside(int(found));
        uint lot = close_lot(entry);
        if (alone) atomicAdd(close_wanted[lot], 1u);
        uint at = alone && lot < close_lots ? atomicAdd(close_taken, 1u) : 0xffffffffu;
        if (at < close_free_count) {
            uint slot = close_free[at];
            close_points[slot] = pack_point(x, n);
            close_owners[slot] = uvec2(entry, is_lit ? found : without);
            place = uint(close_first) + slot;
        }
        is_close = false;
    }
    return place;
}

#endif
