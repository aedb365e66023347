#version 450 core
// What the listed lit texels reflect, where colours alone have changed.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_square.glsl"

layout(std430, binding = 2) writeonly buffer Albedo { vec4 albedo[]; };  // by place
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    int within = lit_resolution * lit_resolution;
    ivec3 p = ivec3(place % lit_resolution, place / lit_resolution % lit_resolution, place / within);
    albedo[place] = vec4(albedo_of(p, square_of(p)), 0.0);
}
