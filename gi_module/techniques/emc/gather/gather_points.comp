#version 450 core
// The surface points of a grid over the picture: of the pixels in its cells' middles.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"

layout(std430, binding = 1) writeonly buffer Points { vec4 points[]; };
layout(std430, binding = 3) writeonly buffer Keys { uint keys[]; };

uniform ivec2 grid;

void main() {
    int i = int(work_item());
    if (i >= grid.x * grid.y) return;
    vec3 x;
    vec3 n;
    float d = surface_at(full_size_pixel(ivec2(i % grid.x, i / grid.x)), x, n);
    points[i] = pack_point(x, n);
    keys[i] = d > 0.0 ? uint(i) : kNoPoint;
}
