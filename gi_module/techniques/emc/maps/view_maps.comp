#version 450 core
// The environment maps as an atlas: a row a map from the top, six faces each.
layout(local_size_x = 8, local_size_y = 8) in;

#include "intersection.glsl"

layout(rgba32f, binding = 0) writeonly uniform image2D atlas;
uniform vec4 slots[MAX_MAPS];  // x: of each map
uniform int cubes;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (p.x >= 6 * map_resolution || p.y >= cubes * map_resolution) return;
    int slot = int(slots[cubes - 1 - p.y / map_resolution].x);
    ivec3 texel = ivec3(p % map_resolution, 6 * slot + p.x / map_resolution);
    vec3 g = plane_at(texel);
    vec3 u = normalize(cube_direction(texel.z % 6, (vec2(texel.xy) + 0.5) / float(map_resolution)));
    vec3 colour = g == vec3(0.0) ? vec3(0.0) : kept_albedo(texelFetch(environment_albedo, texel, 0)) * (0.25 + 0.75 * dot(u, -plane_normal(g)));
    imageStore(atlas, p, vec4(colour, 1.0));
}
