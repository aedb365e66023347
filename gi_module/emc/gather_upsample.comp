#version 450 core
// From the grid of points to pixels: bilinear between the four points around on the pixel's surface; where none of them is,
// between those of the sixteen around; else what the most alike of them has.
layout(local_size_x = 8, local_size_y = 8) in;

#include "point_lists.glsl"
#include "splat_surface.glsl"
#include "gather_surface.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform samplerBuffer points;
uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform ivec2 grid;

// At `q` of the grid: its irradiance, and in a how far it is of the surface of x, 0..1.
vec4 grid_value(ivec2 q, vec3 x, vec3 n, float slack, out float alike) {
    bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, grid));
    q = clamp(q, ivec2(0), grid - 1);
    int at = q.y * grid.x + q.x;
    vec4 e = texelFetch(irradiance, at);
    vec4 point = texelFetch(points, at);
    vec3 m = point_normal(point);
    bool known = inside && e.a >= 0.0;
    vec3 delta = point.xyz - x;
    alike = known ? max(dot(n, m), 1e-3) / (dot(delta, delta) + slack * slack) : 0.0;
    return vec4(e.rgb, known ? same_surface(x, n, point.xyz, m, slack) : 0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    vec3 x;
    vec3 n;
    float d = surface_at(pixel, x, n);
    float slack = 1e-4 * d;
    vec2 at = (vec2(pixel) - float(stride / 2)) / float(stride);
    ivec2 base = ivec2(floor(at));
    vec2 f = at - vec2(base);
    vec4 sum = vec4(0.0);
    float alike;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec4 e = grid_value(base + corner, x, n, slack, alike);
        vec2 w = mix(1.0 - f, f, vec2(corner)) + 1e-3;
        sum += vec4(e.rgb, 1.0) * (w.x * w.y * e.a);
    }
    int k = 0;
    vec4 around = vec4(0.0);
    vec4 any = vec4(0.0);
    while (k < 16 && sum.a < 0.02 && d > 0.0) {
        vec4 e = grid_value(base + ivec2(k % 4, k / 4) - 1, x, n, slack, alike);
        around += vec4(e.rgb, 1.0) * e.a;
        any = alike > any.a ? vec4(e.rgb, alike) : any;
        ++k;
    }
    if (k > 0) sum = around.a > 1e-3 ? around : vec4(any.rgb, 1.0);
    imageStore(picture, pixel, vec4(d > 0.0 && sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), 0.0));
}
