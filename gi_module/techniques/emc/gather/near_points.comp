#version 450 core
// The surface points of listed pixels.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"

layout(std430, binding = 1) writeonly buffer Points { vec4 points[]; };
layout(std430, binding = 3) writeonly buffer Keys { uint keys[]; };

uniform usamplerBuffer pixels;
uniform int pixel_count;

void main() {
    int i = int(work_item());
    if (i >= pixel_count) return;
    int pixel = int(texelFetch(pixels, i).r);
    vec3 x;
    vec3 n;
    surface_at(ivec2(pixel % image_size.x, pixel / image_size.x), x, n);
    points[i] = pack_point(x, n);
    keys[i] = uint(i);
}
