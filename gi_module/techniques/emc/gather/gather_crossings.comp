#version 450 core
// Whether a wall stands between points of the grid and their neighbours on the right and above. FIRST 1: asks for all points the
// map that shows them sharpest; pairs that it does not see both of are listed. FIRST 0: the listed pairs, by all maps, and where
// the wall stands.
layout(local_size_x = 256) in;

#include "engine/render/camera.glsl"
#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_maps.glsl"
#include "point_lists.glsl"
#include "gather_surface.glsl"
#if FIRST
#include "entry_list.glsl"
#else
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
#endif

layout(std430, binding = 4) buffer Crossings { uint crossings[]; };

uniform samplerBuffer points;
uniform ivec2 grid;

// How far off their surface points are looked for, in texels of a map: a wall that is lower is passed over, since the map may have
// no texel of it. No further, or what stands close by would be taken for a wall.
const float kTexels = 1.5;

float lift(vec3 o) { return kTexels * 2.0 * length(o) / float(map_resolution); }  // o: from the map's centre

// The sharpest of the maps that show x less sharply than `sharper`, and how sharp; -1: none is left.
int next_map(vec3 x, vec3 n, inout float sharper) {
    int best = -1;
    float most = 0.0;
    for (int s = 0; s < map_count; ++s) {
        float w = sharpness(x - map_centres[s].xyz, n);
        bool better = w > most && w < sharper && slot_in_use(s, 0.0);
        best = better ? s : best;
        most = better ? w : most;
    }
    sharper = most;
    return best;
}

// The neighbour of point i on the right (k = 0) or above.
vec4 neighbour(int i, int k, out bool inside) {
    ivec2 q = ivec2(i % grid.x, i / grid.x) + ivec2(1 - k, k);
    inside = all(lessThan(q, grid));
    return texelFetch(points, inside ? q.y * grid.x + q.x : i);
}

#if FIRST

void main() {
    int i = int(work_item());
    if (i >= grid.x * grid.y) return;
    vec4 point = texelFetch(points, i);
    vec3 n = point_normal(point);
    float slack = 1e-4 * length(point.xyz);
    float sharper = 3.4e38;
    int slot = next_map(point.xyz, n, sharper);
    float h = lift(point.xyz - map_centres[max(slot, 0)].xyz);
    uint unseen = 0u;
    for (int k = 0; k < 2; ++k) {
        bool inside;
        vec4 other = neighbour(i, k, inside);
        vec3 m = point_normal(other);
        bool linked = inside && other.xyz != point.xyz && same_surface(point.xyz, n, other.xyz, m, slack) > kSomeSurface;
        bool seen = sees(slot, point.xyz + h * n) && sees(slot, other.xyz + h * m);
        unseen |= slot >= 0 && linked && !seen ? 1u << k : 0u;
    }
    crossings[i] = 0u;
    if (unseen != 0u) {
        uint next = append_entries(uint(bitCount(unseen)));
        for (uint k = 0u; k < 2u; ++k) {
            if ((unseen >> k & 1u) != 0u) appended[next++] = 2u * uint(i) + k;
        }
    }
}

#else

vec2 on_screen(vec3 x) {
    vec4 clip = camera_clip_from_relative * vec4(x - camera_position, 1.0);
    return clip.xy / clip.w;
}

// How far on from x to y a wall stands, as a share of the way; < 0: there is none. The sharpest map that sees both, or one of
// them and the wall, has it.
float wall_between(vec3 x, vec3 n, vec3 y, vec3 m) {
    float sharper = 3.4e38;
    int slot = next_map(x, n, sharper);
    float found = -1.0;
    while (slot >= 0 && found < 0.0) {
        float h = lift(x - map_centres[slot].xyz);
        vec3 a = x + h * n;
        vec3 b = y + h * m;
        bool from_x = sees(slot, a);
        bool from_y = sees(slot, b);
        if (from_x && from_y) break;
        vec3 r = (from_x ? b - a : a - b) / max(length(b - a), 1e-20);
        float l = length(b - a);
        float t_max = from_x || from_y ? l : 0.0;
        MapHit hit = march(slot, from_x ? a : b, r, 1e-3 * l, t_max, true);
        found = hit.t < 0.0 ? -1.0 : from_x ? hit.t / l : 1.0 - hit.t / l;
        slot = next_map(x, n, sharper);
    }
    return found;
}

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    int i = int(list[item] >> 1u);
    int k = int(list[item] & 1u);
    bool inside;
    vec4 point = texelFetch(points, i);
    vec4 other = neighbour(i, k, inside);
    vec3 x = point.xyz;
    vec3 y = other.xyz;
    float t = wall_between(x, point_normal(point), y, point_normal(other));
    if (t < 0.0) return;
    vec2 way = on_screen(y) - on_screen(x);
    float share = dot(on_screen(mix(x, y, t)) - on_screen(x), way) / dot(way, way);
    atomicOr(crossings[i], uint(clamp(round(255.0 * share), 1.0, 255.0)) << (8 * k));
}

#endif
