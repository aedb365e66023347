#version 450 core
// One pixel of each cell of the grid, the same in all of them: where this pass shoots from.
layout(local_size_x = 256) in;

#include "point_append.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"

uniform ivec2 grid;
uniform ivec2 offset;  // pixels, in the cell

void main() {
    int i = int(work_item());
    if (i >= grid.x * grid.y) return;
    ivec2 pixel = ivec2(i % grid.x, i / grid.x) * stride + offset;
    if (any(greaterThanEqual(pixel, image_size))) return;
    vec3 x;
    vec3 n;
    if (surface_at(pixel, x, n) > 0.0) append_point(x, n, uint(i));
}
