// The surface points of pixels, and which of them lie on one surface.
#ifndef LANTHORN_COARSE_GRID_COARSE_SURFACE_GLSL
#define LANTHORN_COARSE_GRID_COARSE_SURFACE_GLSL

#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"
#include "plane_tolerance.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;

struct Surface {
    vec3 position;   // relative to the camera
    float distance;  // 0: nothing is seen
    vec3 normal;     // the triangle's own, towards the viewer
};

Surface surface_at(ivec2 pixel) {
    Surface s;
    s.distance = texelFetch(gbuffer_distance, pixel, 0).r;
    s.position = relative_position((vec2(pixel) + 0.5) / vec2(image_size), s.distance);
    s.normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
    return s;
}

bool same_surface(Surface a, Surface b) {
    vec3 span = b.position - a.position;
    float off = max(abs(dot(span, a.normal)), abs(dot(span, b.normal)));
    return b.distance > 0.0 && dot(a.normal, b.normal) > kLeastTurn && off < plane_tolerance(a.distance);
}

// The lattice that a pixel is first on: the largest power of 2, at most `spacing`, that divides both its coordinates.
int lattice_of(ivec2 pixel, int spacing) {
    int bits = pixel.x | pixel.y | spacing;
    return bits & -bits;
}

#endif
