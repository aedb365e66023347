// The surface points that splats are summed at, by full-size pixel, and how far their surfaces go on around them.
#ifndef LANTHORN_EMC_SPLAT_SURFACE_GLSL
#define LANTHORN_EMC_SPLAT_SURFACE_GLSL

#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;
uniform int stride;  // full-size pixels a side of this level's pixels
uniform float bandwidth_max;

ivec2 full_size_pixel(ivec2 p) { return min(p * stride + stride / 2, image_size - 1); }

// Surface point of a full-size pixel; its distance, 0 for background.
float surface_at(ivec2 pixel, out vec3 position, out vec3 normal) {
    float d = texelFetch(gbuffer_distance, pixel, 0).r;
    position = render_position((vec2(pixel) + 0.5) / vec2(image_size), d);
    normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
    return d;
}

// 5 degrees off the axes, along which walls and rows of texels like to run.
vec3 surface_tangent(vec3 normal) {
    vec3 t = normalize(abs(normal.x) < 0.5 ? vec3(0.0, -normal.z, normal.y) : vec3(-normal.y, normal.x, 0.0));
    return 0.99619470 * t + 0.08715574 * cross(normal, t);
}

// The surface around a point is the polygon of eight corners in the tangent plane: corner k lies at k * 45 degrees from the
// tangent towards cross(normal, tangent). A polygon of kReach holds the whole disc of radius bandwidth_max. The corners' radii
// are kept in units of it, 16 bits each.
const int kCorners = 8;
const float kReach = 1.08239220;  // 1 / cos(22.5 degrees)

// A surface around a point ends where its normal is turned away from the point's by more (a cosine); photons beyond are passed
// over. Round things smaller than the splats are lit by what falls on all of their side, walls by none of the next one.
const float kLeastTurn = 0.25;

// The kernel's weights are kept for four bandwidths h, kNodes = (bandwidth_max / h)^2: a photon's lies between
// them (kPdfRange of photon_tracing.cpp).
const vec4 kNodes = vec4(1.0, 2.0, 3.0, 4.0);

// Shares of the four nodes at x = (bandwidth_max / h)^2: Lagrange's cubic.
vec4 node_weights(float x) {
    vec4 f = clamp(x, 1.0, 4.0) - kNodes;
    return vec4(f.y * f.z * f.w / -6.0, f.x * f.z * f.w / 2.0, f.x * f.y * f.w / -2.0, f.x * f.y * f.z / 6.0);
}

uvec4 pack_radii(vec4 low, vec4 high) {
    return uvec4(packUnorm2x16(low.xy), packUnorm2x16(low.zw), packUnorm2x16(high.xy), packUnorm2x16(high.zw));
}

void unpack_radii(uvec4 radii, out vec4 low, out vec4 high) {
    low = vec4(unpackUnorm2x16(radii.x), unpackUnorm2x16(radii.y));
    high = vec4(unpackUnorm2x16(radii.z), unpackUnorm2x16(radii.w));
}

#endif
