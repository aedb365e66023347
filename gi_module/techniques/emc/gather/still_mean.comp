#version 450 core
// Takes what a pass's rays have brought to its pixels into the means of all of theirs.
layout(local_size_x = 256) in;

#include "point_lists.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 5) buffer Mean { vec4 mean[]; };  // lux; a: lux^2, < 0: nothing is known
layout(std430, binding = 6) buffer Known { float known[]; };

uniform samplerBuffer irradiance;  // by point
uniform samplerBuffer rays;        // behind it
uniform int stride;
uniform ivec2 grid;
uniform ivec2 offset;
uniform ivec2 image_size;

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    vec4 now = texelFetch(irradiance, int(i));
    float more = texelFetch(rays, int(i)).r;
    if (now.a < 0.0 || more == 0.0) return;
    int cell = int(keys[i]);
    ivec2 pixel = ivec2(cell % grid.x, cell / grid.x) * stride + offset;
    int at = pixel.y * image_size.x + pixel.x;
    float all = known[at] + more;
    mean[at] = mix(max(mean[at], vec4(0.0)), now, more / all);
    known[at] = all;
}
