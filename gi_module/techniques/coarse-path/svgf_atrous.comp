#version 450 core
// One level of the edge-avoiding a-trous wavelet filter, guided by variance (Dammertz et al. 2010; Schied et al. 2017, sec. 4.3
// and 4.4, eqs. 2 to 5): 5x5 points, `step` apart, weighed by normal, plane and luminance.
layout(local_size_x = 8, local_size_y = 8) in;

#include "engine/render/camera.glsl"
#include "gi_module/shared/coarse_grid/plane_tolerance.glsl"

uniform samplerBuffer points;  // SurfacePoint
uniform sampler2D light;       // lux, variance of the luminance
uniform sampler2D planes;      // normal, distance from the camera's position; 0: nothing
uniform sampler2D guide;       // luminance; by it instead of the light's own if GUIDED
uniform ivec2 cells;
uniform int step_size;
uniform float sigma;    // of the luminance, in standard deviations
layout(rgba32f, binding = 0) uniform writeonly image2D filtered;

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

#if GUIDED
float guide_at(ivec2 cell, vec3 colour) { return texelFetch(guide, cell, 0).r; }
#else
float guide_at(ivec2 cell, vec3 colour) { return luminance(colour); }
#endif

// The variance around a point, by a 3x3 Gaussian (sec. 4.4): one point's own is itself uncertain.
float variance_around(ivec2 cell) {
    vec2 sum = vec2(0.0);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            float w = float((2 - abs(x)) * (2 - abs(y)));
            sum += w * vec2(1.0, texelFetch(light, clamp(cell + ivec2(x, y), ivec2(0), cells - 1), 0).a);
        }
    }
    return sum.y / sum.x;
}

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, cells))) return;
    vec4 where = texelFetch(points, 2 * (cell.y * cells.x + cell.x));
    vec4 own = texelFetch(light, cell, 0);
    if (where.w <= 0.0) {
        imageStore(filtered, cell, vec4(0.0));
        return;
    }
    vec3 position = where.xyz - camera_position;
    vec3 normal = texelFetch(planes, cell, 0).xyz;
    float by_plane = 1.0 / plane_tolerance(where.w);
    float l = guide_at(cell, own.rgb);
    float uncertain = variance_around(cell);
    const float kernel[3] = float[3](0.375, 0.25, 0.0625);  // the B3 spline
    vec3 sum = vec3(0.0);
    float variance = 0.0;
    float total = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = cell + step_size * ivec2(x, y);
            if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, cells))) continue;
            vec4 plane = texelFetch(planes, q, 0);
            vec4 other = texelFetch(light, q, 0);
            float turn = max(dot(normal, plane.xyz), 0.0);
            turn *= turn;
            turn *= turn;
            turn *= turn;  // to the 8th: the facets of round things belong together
            float off = abs(dot(plane.xyz, position) - plane.w) * by_plane;
            // By both variances: a dark point that is sure of itself must not pass over bright ones that are not, which
            // take it in. That would lose light.
            float differs = abs(guide_at(q, other.rgb) - l) / (sigma * sqrt(0.5 * (uncertain + other.a)) + 1e-4 * l + 1e-30);
            float w = kernel[abs(x)] * kernel[abs(y)] * turn * exp(-off - differs);
            sum += w * other.rgb;
            variance += w * w * other.a;
            total += w;
        }
    }
    imageStore(filtered, cell, total > 0.0 ? vec4(sum / total, variance / (total * total)) : own);
}
