#version 450 core
// After something has moved: rays that it may have crossed are stale; the others are listed if a lit texel shows something else
// than what they met, to be looked up again (remembered_again.comp). That is apart because a software rasteriser runs, for
// every ray, what a few rays need. IN_PICTURE 0: rays of points of the lit maps that are no more are forgotten.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "entry_list.glsl"

#define MAX_BOXES 16

layout(std430, binding = 1) buffer Stale { uint stale_count; };
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };

uniform usamplerBuffer remembered;  // texels
uniform samplerBuffer starts;
uniform usamplerBuffer flights;     // direction, distance
#if !IN_PICTURE
uniform usamplerBuffer key_index;   // by key: number of its point + 1
uniform samplerBuffer points;       // by number
#endif
uniform usamplerBuffer changed;     // by place: the lit texel shows something else than in the frame before
#if IN_PICTURE
uniform usamplerBuffer cells;       // by start
#endif
uniform int frame;
uniform float scene_diagonal;
uniform int box_count;
uniform vec4 box_lower[MAX_BOXES];  // render space: where movers are and were
uniform vec4 box_upper[MAX_BOXES];

// Whether a mover may have come between a start and what its ray met. `inside`: the start lies where a mover is or was.
bool crosses_a_box(vec3 x, vec3 d, float l, out bool inside) {
    vec3 inverse = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    bool crosses = false;
    inside = false;
    for (int b = 0; b < box_count; ++b) {
        vec3 t0 = (box_lower[b].xyz - x) * inverse;
        vec3 t1 = (box_upper[b].xyz - x) * inverse;
        vec3 near = min(t0, t1);
        vec3 far = max(t0, t1);
        float enter = max(max(near.x, near.y), near.z);
        float leave = min(min(far.x, far.y), far.z);
        bool within = enter < 0.0 && leave > 0.0;
        inside = inside || within;
        crosses = crosses || (!within && max(enter, 0.0) <= min(leave, l));
    }
    return crosses;
}

#if !IN_PICTURE
bool starts_at_a_point(vec4 start, uint key) {
    uint number = texelFetch(key_index, int(key)).r;
    vec4 point = texelFetch(points, max(int(number) - 1, 0));
    vec3 off = start.xyz - point.xyz;
    // Closer than rays start off their surfaces (scatter.glsl).
    return number != 0u && floatBitsToUint(start.w) == floatBitsToUint(point.w) && dot(off, off) < 4e-10 * scene_diagonal * scene_diagonal;
}
#endif

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint slot = slot_of_row(item_row());
    uint entry = item_row() * uint(capacity) + key;
    uint before = texelFetch(remembered, int(entry)).r;
    uint id = met(before);
    if (id == kNoRay) return;
    int at = int(start_of(slot, key));
    vec4 start = texelFetch(starts, at);
#if !IN_PICTURE
    if (!starts_at_a_point(start, key)) {
        texels[entry] = kNoRay;
        return;
    }
#endif
    uvec2 flight = texelFetch(flights, int(entry)).rg;
    vec3 d = unpack_direction(flight.x);
    float l = uintBitsToFloat(flight.y);
    bool nothing = l == 0.0;  // met
    bool inside;
    bool stale = before != id || crosses_a_box(start.xyz, d, nothing ? scene_diagonal : l, inside);
    bool turn = slot == uint(frame);
#if IN_PICTURE
    // What a mover carries along still meets nearly the same: a quarter of it is traced again, in turns.
    bool is_carried = (texelFetch(cells, at).y & kCarried) != 0u;
    stale = stale || (inside && (!is_carried || (slot & 3u) == (uint(frame) & 3u)));
#else
    stale = stale || inside;
#endif
    // What met nothing known may be shown by now; that is looked for once in a round of slots.
    bool look = id < kNoRay ? texelFetch(changed, int(id)).r != 0u : !nothing && turn;
    if (look && !stale) list_entry(entry);
    if (stale) {
        atomicAdd(stale_count, 1u);
        id |= kStale;
    }
    if (id != before) texels[entry] = id;
}
