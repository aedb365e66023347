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

vec3 surface_tangent(vec3 normal) {
    return normalize(abs(normal.x) < 0.5 ? vec3(0.0, -normal.z, normal.y) : vec3(-normal.y, normal.x, 0.0));
}

// The tangent plane is looked at in eight sectors; sector k is centred at (k + 1/2) * 45 degrees from the tangent towards
// cross(normal, tangent). Their free radii in units of bandwidth_max, 16 bits each.
const int kSectors = 8;

uvec4 pack_radii(vec4 low, vec4 high) {
    return uvec4(packUnorm2x16(low.xy), packUnorm2x16(low.zw), packUnorm2x16(high.xy), packUnorm2x16(high.zw));
}

void unpack_radii(uvec4 radii, out vec4 low, out vec4 high) {
    low = vec4(unpackUnorm2x16(radii.x), unpackUnorm2x16(radii.y));
    high = vec4(unpackUnorm2x16(radii.z), unpackUnorm2x16(radii.w));
}

#endif
