#version 450 core
// The points that light is computed at: every pixel of the lattice, and each pixel between for which none of the coarser
// pixels around it lies on its surface. For the others it is noted which of them do.
layout(local_size_x = 8, local_size_y = 8) in;

#include "coarse_surface.glsl"

layout(std430, binding = 0) writeonly buffer Points { vec4 points[]; };  // SurfacePoint
layout(std430, binding = 1) buffer Count { uint extra_count; };
layout(r32ui, binding = 0) uniform writeonly uimage2D fits;  // bit k: the coarser pixel at corner k; coarse_upsampling.comp
uniform int spacing;
uniform ivec2 cells;
uniform uint capacity;  // of extra points

void write(uint place, ivec2 pixel, Surface s) {
    points[2u * place] = vec4(camera_position + s.position, s.distance);
    points[2u * place + 1u] = vec4(s.normal, uintBitsToFloat(uint(pixel.x) | uint(pixel.y) << 16u));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    Surface s = surface_at(pixel);
    int lattice = lattice_of(pixel, spacing);
    if (lattice == spacing) {
        ivec2 cell = pixel / spacing;
        write(uint(cell.y * cells.x + cell.x), pixel, s);
        return;
    }
    uint bits = 0u;
    ivec2 base = pixel & ~(2 * lattice - 1);
    ivec2 across = ivec2(notEqual(base, pixel));  // on a line of the coarser lattice its two neighbours do
    for (int k = 0; k < 4 && s.distance > 0.0; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        ivec2 q = base + 2 * lattice * corner;
        if (any(greaterThan(corner, across)) || any(greaterThanEqual(q, image_size))) continue;
        bits |= same_surface(s, surface_at(q)) ? 1u << uint(k) : 0u;
    }
    imageStore(fits, pixel, uvec4(bits));
    if (bits != 0u || s.distance <= 0.0) return;
    uint place = atomicAdd(extra_count, 1u);
    if (place < capacity) write(uint(cells.x * cells.y) + place, pixel, s);
}
