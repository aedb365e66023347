#version 450 core
// Starts that are seen nowhere: what lies on something that moves is carried along. A start that is seen nowhere there either is
// forgotten with its rays.
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
#define MAX_CARRIES 16
uniform int carry_count;
uniform vec4 carry_lower[MAX_CARRIES];  // render space: where what is carried was
uniform vec4 carry_upper[MAX_CARRIES];
uniform vec4 carry_rows[3 * MAX_CARRIES];

vec3 carried(int m, vec4 v) { return vec3(dot(carry_rows[3 * m], v), dot(carry_rows[3 * m + 1], v), dot(carry_rows[3 * m + 2], v)); }

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    uint at = list[item];
    uint slot = at / uint(capacity);
    uint key = at % uint(capacity);
    vec4 start = texelFetch(starts, int(at));
    vec3 n = point_normal(start);
    uint cell = kNoPoint;
    int m = 0;
    while (m < carry_count && cell == kNoPoint) {
        if (all(greaterThan(start.xyz, carry_lower[m].xyz)) && all(lessThan(start.xyz, carry_upper[m].xyz))) {
            vec3 x = carried(m, vec4(start.xyz, 1.0));
            vec3 turned = normalize(carried(m, vec4(n, 0.0)));
            cell = cell_of(x, turned);
            if (cell != kNoPoint) {
                carried_starts[at] = pack_point(x, turned);
                for (uint j = 0u; j < uint(rays); ++j) {
                    uint entry = entry_of(slot, j, key);
                    vec3 d = unpack_direction(texelFetch(flights, int(entry)).x);
                    carried_flights[2u * entry] = pack_direction(normalize(carried(m, vec4(d, 0.0))));
                }
            }
        }
        ++m;
    }
    if (cell == kNoPoint) {
        for (uint j = 0u; j < uint(rays); ++j) texels[entry_of(slot, j, key)] = kNoRay;
    } else {
        cells[at] = uvec2(cell, atomicAdd(counts[cell], 1u) | kCarried);
    }
}
