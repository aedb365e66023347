#version 450 core
// One level of up-sampling: the pixels that are on this lattice first, interpolated between those of the coarser one that lie on
// their surface. Pixels that are extra points stay as they are.
layout(local_size_x = 8, local_size_y = 8) in;

uniform usampler2D fits;  // bit k: the coarser pixel at corner k lies on the pixel's surface
uniform ivec2 image_size;
uniform int lattice;
layout(rgba32f, binding = 0) uniform image2D irradiance;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 base = 2 * lattice * block;
    if (any(greaterThanEqual(base, image_size))) return;
    vec3 coarse[4];
    for (int k = 0; k < 4; ++k) coarse[k] = imageLoad(irradiance, base + 2 * lattice * ivec2(k & 1, k >> 1)).rgb;
    for (int j = 1; j < 4; ++j) {
        ivec2 pixel = base + lattice * ivec2(j & 1, j >> 1);
        if (any(greaterThanEqual(pixel, image_size))) continue;
        uint bits = texelFetch(fits, pixel, 0).r;
        vec4 sum = vec4(0.0);
        for (int k = 0; k < 4; ++k) sum += (bits & (1u << uint(k))) != 0u ? vec4(coarse[k], 1.0) : vec4(0.0);
        if (sum.a > 0.0) imageStore(irradiance, pixel, vec4(sum.rgb / sum.a, 0.0));
    }
}
