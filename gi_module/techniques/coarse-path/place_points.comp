#version 450 core
// Puts the filtered light of the lattice at its pixels, and notes which pixels the extra points are.
layout(local_size_x = 64) in;

uniform samplerBuffer points;  // SurfacePoint
uniform sampler2D light;
uniform ivec2 cells;
uniform int count;
layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;
layout(r32ui, binding = 1) uniform writeonly uimage2D extras;  // 1 + number of the extra point; 0: none

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    uint word = floatBitsToUint(texelFetch(points, 2 * i + 1).w);
    ivec2 pixel = ivec2(word & 0xffffu, word >> 16u);
    int lattice = cells.x * cells.y;
    if (i < lattice) {
        imageStore(irradiance, pixel, texelFetch(light, ivec2(i % cells.x, i / cells.x), 0));
    } else {
        imageStore(extras, pixel, uvec4(1 + i - lattice));
    }
}
