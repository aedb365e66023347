#version 450 core
// How large the surface is whose photons each coarse texel counts: the sum over the parts of lit texels.
layout(local_size_x = 256) in;

#include "lit_hits.glsl"
#include "lit_points.glsl"

layout(std430, binding = 5) buffer Sums { uint sums[]; };  // by place of the coarse texel: two words
#include "fixed_sums.glsl"
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

// By place of the lit texel.
uniform usamplerBuffer homes;  // that of the coarse texel + 1; 0: none
uniform usamplerBuffer found;  // lit_photon_areas.comp
uniform samplerBuffer areas;
uniform float units;           // a square metre

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    uvec4 which = texelFetch(found, place);
    vec4 area = texelFetch(areas, place);
    uint last = 0u;
    float sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        uint home = which[k] < kListed ? texelFetch(homes, int(which[k])).r : 0u;
        if (home != last) {
            if (last != 0u) add_units(last - 1u, sum * units);
            last = home;
            sum = 0.0;
        }
        sum += area[k];
    }
    if (last != 0u) add_units(last - 1u, sum * units);
}
