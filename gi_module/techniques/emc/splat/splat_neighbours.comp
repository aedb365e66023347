#version 450 core
// For up-sampling: which of the four coarse pixels around it lie on the surface of each pixel. Depends on the camera's surfaces
// alone, so it holds while they do. One invocation a block of 2x2 pixels that have the same four coarse pixels around them.
layout(local_size_x = 8, local_size_y = 8) in;

#include "splat_blocks.glsl"
#include "splat_surface.glsl"

layout(r32ui, binding = 1) uniform writeonly uimage2D blocks;

// Splats blur over their radius: between points that lie within this share of it, irradiance may be interpolated.
const float kFarthest = 0.6;
// Cosine of the angle between their normals, at least. 0.8 and 0.95 gave the same errors within half a percent.
const float kLeastCosine = 0.9;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(blocks)))) return;
    vec3 coarse_position[4];
    vec3 coarse_normal[4];
    bool coarse_surface[4];
    for (int k = 0; k < 4; ++k) {
        ivec2 q = coarse_pixel(block, k);
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, coarse_size));
        q = clamp(q, ivec2(0), coarse_size - 1);
        ivec2 pixel = min(q * (2 * stride) + stride, image_size - 1);
        float d = texelFetch(gbuffer_distance, pixel, 0).r;
        coarse_position[k] = relative_position((vec2(pixel) + 0.5) / vec2(image_size), d);
        coarse_normal[k] = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
        coarse_surface[k] = inside && d > 0.0;
    }
    uint bits = 0u;
    for (int j = 0; j < 4; ++j) {
        ivec2 p = block_pixel(block, j);
        bool inside = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, level_size));
        ivec2 pixel = full_size_pixel(clamp(p, ivec2(0), level_size - 1));
        float d = texelFetch(gbuffer_distance, pixel, 0).r;
        vec3 x = relative_position((vec2(pixel) + 0.5) / vec2(image_size), d);
        vec3 n = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
        bool surface = inside && d > 0.0;
        uint around = 0u;
        bool far = false;
        for (int k = 0; k < 4; ++k) {
            // A chord of a round surface is square to the mean of the normals at its ends; of a plane, to both.
            vec3 delta = coarse_position[k] - x;
            float off = 0.5 * dot(n + coarse_normal[k], delta);
            float apart = dot(delta, delta);
            bool near = off * off < 0.01 * apart + 1e-10 * d * d;
            bool same = surface && coarse_surface[k] && near && dot(n, coarse_normal[k]) > kLeastCosine;
            around |= same ? same_bit(j, k) : 0u;
            far = far || (same && apart > kFarthest * kFarthest * bandwidth_max * bandwidth_max);
        }
        bits |= far ? 0u : around;
        bits |= surface ? surface_bit(j) : 0u;
    }
    imageStore(blocks, block, uvec4(bits));
}
