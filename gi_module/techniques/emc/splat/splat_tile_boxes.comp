#version 450 core
// The box around the visible surface points of each tile.
layout(local_size_x = 64) in;

#include "engine/render/camera.glsl"

layout(binding = 0) uniform sampler2D gbuffer_distance;
layout(std430, binding = 2) writeonly buffer TileBoxes { vec4 tile_boxes[]; };
uniform ivec2 tile_grid;
uniform ivec2 image_size;
uniform int tile_size;

shared vec3 lowers[64];
shared vec3 uppers[64];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    int tile = int(gl_WorkGroupID.x);
    ivec2 origin = ivec2(tile % tile_grid.x, tile / tile_grid.x) * tile_size;
    vec3 lower = vec3(1e30);
    vec3 upper = vec3(-1e30);
    for (int i = lane; i < tile_size * tile_size; i += 64) {
        ivec2 p = origin + ivec2(i % tile_size, i / tile_size);
        if (all(lessThan(p, image_size))) {
            float d = texelFetch(gbuffer_distance, p, 0).r;
            if (d > 0.0) {
                vec3 x = render_position((vec2(p) + 0.5) / vec2(image_size), d);
                lower = min(lower, x);
                upper = max(upper, x);
            }
        }
    }
    lowers[lane] = lower;
    uppers[lane] = upper;
    barrier();
    for (int width = 32; width > 0; width >>= 1) {
        if (lane < width) {
            lowers[lane] = min(lowers[lane], lowers[lane + width]);
            uppers[lane] = max(uppers[lane], uppers[lane + width]);
        }
        barrier();
    }
    if (lane == 0) {
        tile_boxes[2 * tile] = vec4(lowers[0], 0.0);
        tile_boxes[2 * tile + 1] = vec4(uppers[0], 0.0);
    }
}
