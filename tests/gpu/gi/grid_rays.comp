#version 450 core
// Whether rays cross what movers sweep, by swept_grid.glsl.
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/gather/swept_grid.glsl"

struct Ray {
    vec4 start;      // w: length, m
    vec4 direction;  // w: whether being inside counts
};
layout(std430, binding = 0) readonly buffer Rays { Ray rays[]; };
layout(std430, binding = 1) writeonly buffer Crossed { uint crossed[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(rays.length())) return;
    Ray ray = rays[i];
    crossed[i] = crosses_the_grid(ray.start.xyz, ray.direction.xyz, ray.start.w, ray.direction.w != 0.0) ? 1u : 0u;
}
