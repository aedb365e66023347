#version 450 core
// Prepares the filter's input: how uncertain each point's light is (Schied et al. 2017, sec. 4.2), from its own samples or,
// while they are few, from those of the points around it on the same surface.
layout(local_size_x = 8, local_size_y = 8) in;

#include "engine/render/camera.glsl"
#include "gi_module/shared/coarse_grid/plane_tolerance.glsl"

uniform samplerBuffer points;     // SurfacePoint
uniform samplerBuffer estimates;  // PointEstimate
uniform sampler2D planes;         // normal, distance from the camera's position; 0: nothing
uniform ivec2 cells;
layout(rgba32f, binding = 0) uniform writeonly image2D light;  // lux, variance of the luminance
layout(r32f, binding = 1) uniform writeonly image2D guide;     // luminance without its worst outliers

const float kFewSamples = 12.0;

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, cells))) return;
    int i = 2 * (cell.y * cells.x + cell.x);
    vec4 where = texelFetch(points, i);
    if (where.w <= 0.0) {
        imageStore(light, cell, vec4(0.0));
        imageStore(guide, cell, vec4(0.0));
        return;
    }
    vec3 position = where.xyz - camera_position;
    vec3 normal = texelFetch(planes, cell, 0).xyz;
    float tolerance = plane_tolerance(where.w);
    vec4 own = texelFetch(estimates, i);
    float samples = max(texelFetch(estimates, i + 1).x, 1.0);
    float mean = luminance(own.rgb);
    float square = own.a;
    vec3 sums = vec3(0.0);  // weight, weighted luminance and its square
    vec2 near = vec2(0.0);  // weight and luminance, by the B3 spline
    const float kernel[3] = float[3](0.375, 0.25, 0.0625);
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = clamp(cell + ivec2(x, y), ivec2(0), cells - 1);
            vec4 plane = texelFetch(planes, q, 0);
            bool same = dot(normal, plane.xyz) > kLeastTurn && abs(dot(plane.xyz, position) - plane.w) < tolerance;
            int j = 2 * (q.y * cells.x + q.x);
            vec4 e = texelFetch(estimates, j);
            float count = same ? texelFetch(estimates, j + 1).x : 0.0;
            float l = luminance(e.rgb);
            sums += count * vec3(1.0, l, e.a);
            near += same ? kernel[abs(x)] * kernel[abs(y)] * vec2(1.0, l) : vec2(0.0);
        }
    }
    if (samples < kFewSamples && sums.x > 0.0) {
        mean = sums.y / sums.x;
        square = sums.z / sums.x;
    }
    float variance = max(square - mean * mean, 0.0) / samples;
    imageStore(light, cell, vec4(own.rgb, variance));
    imageStore(guide, cell, vec4(near.x > 0.0 ? near.y / near.x : luminance(own.rgb)));
}
