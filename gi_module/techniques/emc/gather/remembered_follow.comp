#version 450 core
// Which point of the picture's grid each remembered ray serves now: the one where its own start is seen, by plane and normal; if
// that does not fit, one of the three beside it. A start that is seen nowhere is listed: something may have carried it along
// (remembered_carry.comp).
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "remembered_cells.glsl"
#include "entry_list.glsl"

layout(std430, binding = 1) buffer Counts { uint counts[]; };           // of starts, by cell
layout(std430, binding = 6) writeonly buffer Cells { uvec2 cells[]; };  // by start: cell, place among those of the cell

uniform usamplerBuffer remembered;  // texels
uniform samplerBuffer starts;
uniform vec3 carried_lower;  // render space: around where all was that carries starts along
uniform vec3 carried_upper;

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint slot = item_row();
    uint at = start_of(slot, key);
    bool is_there = met(texelFetch(remembered, int(entry_of(slot, 0u, key))).r) != kNoRay;
    vec4 start = texelFetch(starts, int(at));
    float off;
    uint cell = is_there ? cell_of(start.xyz, point_normal(start), off) : kNoPoint;
    bool may_be_carried = is_there && all(greaterThan(start.xyz, carried_lower)) && all(lessThan(start.xyz, carried_upper));
    uint rank = 0u;
    if (cell != kNoPoint && !may_be_carried) rank = atomicAdd(counts[cell], 1u);
    cells[at] = uvec2(cell, rank);
    if (is_there && (cell == kNoPoint || may_be_carried)) list_entry(at);
}
