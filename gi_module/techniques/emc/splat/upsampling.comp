#version 450 core
// One step of multi-level up-sampling (Yao et al. 2010, sec. 6, fig. 9): each pixel of this level takes what the coarse pixels
// around it on the same surface say; where none fits, or they disagree, it is listed to be gathered.
// One invocation a block of 2x2 pixels that have the same four coarse pixels around them.
layout(local_size_x = 8, local_size_y = 8) in;

#include "splat_blocks.glsl"
#include "splat_lists.glsl"

uniform sampler2D coarse;
layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;
layout(r32ui, binding = 1) uniform uimage2D blocks;
layout(std430, binding = 2) writeonly buffer Listed { uint listed[]; };  // by tile
layout(std430, binding = 3) buffer TileCounts { uint tile_counts[]; };
layout(std430, binding = 4) writeonly buffer NewPixels { uint new_pixels[]; };
layout(std430, binding = 7) writeonly buffer Batches { uint batches[]; };
uniform ivec2 image_size;
uniform ivec2 tile_grid;
uniform int tile_size;
uniform int stride;       // of this level; the coarse one's is twice that
uniform float contrast;

void list(ivec2 p, bool known) {
    int side = tile_size / stride;
    ivec2 tile_xy = p / side;
    int tile = tile_xy.y * tile_grid.x + tile_xy.x;
    uint word = uint(p.x) | (uint(p.y) << 16u);
    uint place = atomicAdd(tile_counts[tile], 1u);
    listed[uint(tile * side * side) + place] = word;
    if (place % kBatch == 0u) {
        uint batch = atomicAdd(batch_count, 1u);
        batches[batch] = (uint(tile) << 10u) | (place / kBatch);
        COUNT_GROUPS(batch_groups, batch, batch, 1u)
    }
    if (!known) {
        uint at = atomicAdd(new_count, 1u);
        new_pixels[at] = word;
        COUNT_GROUPS(new_groups, at, at, 64u)
    }
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(blocks)))) return;
    uint bits = imageLoad(blocks, block).r;
    vec3 e[4];
    float y[4];
    for (int k = 0; k < 4; ++k) {
        ivec2 q = clamp(coarse_pixel(block, k), ivec2(0), coarse_size - 1);
        e[k] = texelFetch(coarse, q, 0).rgb;
        y[k] = dot(e[k], vec3(0.2126, 0.7152, 0.0722));
    }
    uint redo = 0u;
    for (int j = 0; j < 4; ++j) {
        ivec2 p = block_pixel(block, j);
        vec2 f = (vec2(min(p * stride + stride / 2, image_size - 1)) - float(stride)) / float(2 * stride) - vec2(block - 1);
        vec3 sum = vec3(0.0);
        float total = 0.0;
        float lowest = 1e30;
        float highest = 0.0;
        for (int k = 0; k < 4; ++k) {
            bool same = (bits & same_bit(j, k)) != 0u;
            vec2 w2 = mix(1.0 - f, f, vec2(corner(k)));
            float w = same ? w2.x * w2.y + 1e-4 : 0.0;
            sum += w * e[k];
            total += w;
            lowest = same ? min(lowest, y[k]) : lowest;
            highest = same ? max(highest, y[k]) : highest;
        }
        bool surface = (bits & surface_bit(j)) != 0u;
        bool redone = surface && (total < 0.02 || highest - lowest > contrast * highest);
        redo |= redone ? 1u << uint(j) : 0u;
        imageStore(irradiance, p, vec4(total > 0.0 ? sum / total : vec3(0.0), 0.0));  // outside the image: no effect
    }
    uint known = bits;
    // A loop rather than branches: a vector of blocks skips most of it together.
    while (redo != 0u) {
        int j = findLSB(redo);
        redo &= redo - 1u;
        list(block_pixel(block, j), (known & known_bit(j)) != 0u);
        known |= known_bit(j);
    }
    if (known != bits) imageStore(blocks, block, uvec4(known));
}
