#version 450 core
// Counts the parts of all listed lit texels.
layout(local_size_x = 256) in;

#include "lit_points.glsl"
#include "lit_photon_parts.glsl"

layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

// By place of the lit texel.
uniform usamplerBuffer homes;  // that of the coarse texel + 1; 0: none
uniform samplerBuffer parts;   // m^2

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    count_parts(texelFetch(homes, place).r, texelFetch(parts, place), false);
}
