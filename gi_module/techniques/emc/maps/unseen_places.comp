#version 450 core
// What rays from the picture have met that no lit texel shows: one such ray of each tile of the gather's grid, and how many there
// are; and the same of what reserved maps alone show. A group a tile. The same whatever order groups run in.
layout(local_size_x = 64) in;

#include "intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "gi_module/techniques/emc/gather/remembered.glsl"

struct Tile {
    vec4 start;           // of a ray that met what no lit texel shows; w: how many rays of the tile did
    vec4 place;           // that it met; w: 1 if a map sees it even so, too coarsely
    vec4 reserved_start;  // of a ray that met what reserved maps alone show; w: how many did, by the look of this one
    vec4 reserved_place;
    vec4 counts;          // x: rays, y: points a quarter of whose rays met what no lit texel shows, z: points, w: such rays
};
layout(std430, binding = 1) writeonly buffer Tiles { Tile tiles[]; };

uniform usamplerBuffer remembered;
uniform usamplerBuffer flights;
uniform usamplerBuffer cells;  // by start: the point that it serves
uniform samplerBuffer starts;
uniform ivec2 grid;
uniform ivec2 tile_size;       // points
uniform ivec2 reserved_slots;  // of maps; -1: none

const uint kNone = 0xffffffffu;

// By lane. x: rank, y: entry, of the ray with the lowest rank; w: how many.
shared uvec4 unknown[64];
shared uvec4 reserved[64];
shared uvec4 counted[64];  // Tile::counts

bool is_reserved(int slot) { return slot == reserved_slots.x || slot == reserved_slots.y; }

// Whether a map that is not reserved sees x, met in direction d.
bool seen_by_others(vec3 x, vec3 d) {
    bool seen = false;
    for (int s = 0; s < map_count; ++s) {
        vec3 o = x - map_centres[s].xyz;
        vec3 g = plane_at(map_texel(s, o));
        // On the plane that the texel shows, within its width, from the side that the ray came from.
        float width = 2.0 / float(map_resolution);
        bool shown = g != vec3(0.0) && dot(o, d) > 0.0 && abs(dot(o, g) - 1.0) < width * (1.0 + length(o) * length(g));
        seen = seen || (shown && slot_in_use(s, 0.0) && !is_reserved(s));
    }
    return seen;
}

vec3 place_of(uint entry, out vec3 start, out vec3 d) {
    uvec2 flight = texelFetch(flights, int(entry)).rg;
    start = texelFetch(starts, start_of(entry)).xyz;
    d = unpack_direction(flight.x);
    return start + d * uintBitsToFloat(flight.y);
}

uvec4 lower(uvec4 a, uvec4 b) { return uvec4(b.x < a.x ? b.xyz : a.xyz, a.w + b.w); }

void main() {
    uint lane = gl_LocalInvocationID.x;
    ivec2 tile = ivec2(gl_WorkGroupID.xy);
    uvec4 its_unknown = uvec4(kNone, 0u, 0u, 0u);
    uvec4 its_reserved = its_unknown;
    uvec4 its_counts = uvec4(0u);
    for (int k = int(lane); k < tile_size.x * tile_size.y; k += 64) {
        ivec2 p = tile * tile_size + ivec2(k % tile_size.x, k / tile_size.x);
        if (any(greaterThanEqual(p, grid))) continue;
        uint key = uint(p.y * grid.x + p.x);
        uint all = 0u;
        uint missed = 0u;
        for (uint slot = 0u; slot < kRemembered; ++slot) {
            if (texelFetch(cells, int(start_of(slot, key))).r == kNoPoint) continue;
            for (uint j = 0u; j < uint(rays); ++j) {
                uint entry = entry_of(slot, j, key);
                uint id = met(texelFetch(remembered, int(entry)).r);
                // Any order of rays that has nothing to do with where they are (Knuth's multiplier).
                uint rank = entry * 2654435761u;
                // Of a ray that no map could follow it is not known what it met.
                bool at_a_place = id == kUnlit && texelFetch(flights, int(entry)).g != 0u;
                int of = id < kNoRay ? int(id) / (6 * lit_resolution * lit_resolution) : -2;
                all += id != kNoRay ? 1u : 0u;
                missed += id == kUnlit ? 1u : 0u;
                its_unknown = at_a_place ? lower(its_unknown, uvec4(rank, entry, 0u, 1u)) : its_unknown;
                its_reserved = is_reserved(of) ? lower(its_reserved, uvec4(rank, entry, 0u, 1u)) : its_reserved;
            }
        }
        its_counts += uvec4(all, all > 0u && 4u * missed >= all ? 1u : 0u, all > 0u ? 1u : 0u, missed);
    }
    unknown[lane] = its_unknown;
    reserved[lane] = its_reserved;
    counted[lane] = its_counts;
    barrier();
    if (lane != 0u) return;
    for (int k = 1; k < 64; ++k) {
        its_unknown = lower(its_unknown, unknown[k]);
        its_reserved = lower(its_reserved, reserved[k]);
        its_counts += counted[k];
    }
    Tile found;
    vec3 start;
    vec3 d;
    vec3 x = place_of(its_unknown.y, start, d);
    found.start = vec4(start, its_unknown.w);
    found.place = vec4(x, seen_by_others(x, d) ? 1.0 : 0.0);
    x = place_of(its_reserved.y, start, d);
    bool alone = its_reserved.w > 0u && !seen_by_others(x, d);
    found.reserved_start = vec4(start, alone ? float(its_reserved.w) : 0.0);
    found.reserved_place = vec4(x, 0.0);
    found.counts = vec4(its_counts);
    tiles[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = found;
}
