#version 450 core
// Starts that are seen nowhere, or where something has moved: what lies on that is carried along. A start may fit where it was,
// too; what it fits best counts. One that is seen nowhere is forgotten with its rays.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "remembered_cells.glsl"

layout(std430, binding = 1) buffer Counts { uint counts[]; };  // of starts, by cell
layout(std430, binding = 2) writeonly buffer Starts { vec4 carried_starts[]; };
layout(std430, binding = 3) writeonly buffer Cells { uvec2 cells[]; };  // by start: cell, place among those of the cell
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uint carried_flights[]; };
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer starts;
uniform usamplerBuffer flights;
#define MAX_MOVERS 16
uniform int mover_count;
uniform vec4 mover_lower[MAX_MOVERS];  // render space: where what is carried was; a: its first part
uniform vec4 mover_upper[MAX_MOVERS];  // a: the part after its last
// Five a part: where it was, as of movers (a of the second: 1 if it bends), and the rows of what carries it along.
uniform samplerBuffer parts;
uniform float margin;  // m: how far off its surface a ray starts

vec3 carried(int part, vec4 v) {
    return vec3(dot(texelFetch(parts, 5 * part + 2), v), dot(texelFetch(parts, 5 * part + 3), v), dot(texelFetch(parts, 5 * part + 4), v));
}

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint at = list[item];
    uint slot = at / uint(capacity);
    uint key = at % uint(capacity);
    vec4 start = texelFetch(starts, int(at));
    vec3 n = point_normal(start);
    float off;
    uint cell = cell_of(start.xyz, n, off);
    // A start may slide over a plane that does not move: only what fits better by more than rounding is carried.
    float best = cell == kNoPoint ? 1e30 : max(abs(off) - margin, 0.0);
    int carrier = -1;
    for (int m = 0; m < mover_count; ++m) {
        bool holds = all(greaterThan(start.xyz, mover_lower[m].xyz)) && all(lessThan(start.xyz, mover_upper[m].xyz));
        int part = int(mover_lower[m].w);
        int end = holds ? int(mover_upper[m].w) : part;
        while (part < end) {
            vec3 lower = texelFetch(parts, 5 * part).xyz;
            vec3 upper = texelFetch(parts, 5 * part + 1).xyz;
            if (all(greaterThan(start.xyz, lower)) && all(lessThan(start.xyz, upper))) {
                uint seen = cell_of(carried(part, vec4(start.xyz, 1.0)), normalize(carried(part, vec4(n, 0.0))), off);
                if (seen != kNoPoint && abs(off) < best) {
                    best = abs(off);
                    cell = seen;
                    carrier = part;
                }
            }
            ++part;
        }
    }
    if (cell == kNoPoint) {
        for (uint j = 0u; j < uint(rays); ++j) texels[entry_of(slot, j, key)] = kNoRay;
        return;
    }
    uint flag = 0u;
    if (carrier >= 0) {
        flag = kCarried;
        vec3 x = carried(carrier, vec4(start.xyz, 1.0));
        vec3 turned = normalize(carried(carrier, vec4(n, 0.0)));
        if (texelFetch(parts, 5 * carrier + 1).w != 0.0) {
            // What bends has a surface that is no longer quite there: inside it all rays would be dark.
            vec4 point = texelFetch(points, int(cell));
            x -= point_normal(point) * dot(x - point.xyz, point_normal(point));
        }
        carried_starts[at] = pack_point(x, turned);
        for (uint j = 0u; j < uint(rays); ++j) {
            uint entry = entry_of(slot, j, key);
            vec3 d = unpack_direction(texelFetch(flights, int(entry)).x);
            carried_flights[2u * entry] = pack_direction(normalize(carried(carrier, vec4(d, 0.0))));
        }
    }
    cells[at] = uvec2(cell, atomicAdd(counts[cell], 1u) | flag);
}
