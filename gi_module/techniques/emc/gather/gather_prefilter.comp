#version 450 core
// What the filter's luminance stop goes by: the mean luminance of rays and its mean square, pooled over 3 x 3 points of a surface.
// A point's own few rays would not do: where they miss what is bright they seem certain, and the picture darkens. FIRST 1: from
// the gathered points, 0: from the level before.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gather_surface.glsl"
#include "gather_trust.glsl"
#include "gather_links.glsl"

layout(std430, binding = 4) writeonly buffer Guide { vec2 guide[]; };  // lux, lux^2

uniform samplerBuffer points;
uniform samplerBuffer irradiance;  // lux; a: mean square, < 0: nothing is known
#if !FIRST
uniform samplerBuffer before;
#endif
uniform ivec2 grid;
uniform int first_item;
uniform usamplerBuffer cuts;   // links that a wall stands in
uniform samplerBuffer known;  // rays behind a point's irradiance
uniform int level;

void main() {
    int i = first_item + int(work_item());
    if (i >= grid.x * grid.y) return;
    ivec2 p = ivec2(i % grid.x, i / grid.x);
    vec4 point = texelFetch(points, i);
    vec3 n = point_normal(point);
    float slack = 1e-4 * length(point.xyz);
#if !FIRST
    if (texelFetch(known, i).r >= kFewRays) {
        guide[i] = texelFetch(before, i).rg;
        return;
    }
#endif
    uint walls = texelFetch(cuts, i).r;
    vec2 sum = vec2(0.0);
    float total = 1e-20;
    for (int k = 0; k < 9; ++k) {
        ivec2 off = ivec2(k % 3 - 1, k / 3 - 1);
        ivec2 q = p + (1 << level) * off;
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, grid));
        q = clamp(q, ivec2(0), grid - 1);
        int at = q.y * grid.x + q.x;
        vec4 e = texelFetch(irradiance, at);
        vec4 other = texelFetch(points, at);
        float w = (off.x == 0 ? 0.5 : 0.25) * (off.y == 0 ? 0.5 : 0.25);
        w *= inside && e.a >= 0.0 && !is_cut(walls, level, k) ? same_surface(point.xyz, n, other.xyz, point_normal(other), slack) : 0.0;
#if FIRST
        vec2 moments = vec2(luminance(e.rgb), e.a);
#else
        vec2 moments = texelFetch(before, at).rg;
#endif
        sum += w * moments;
        total += w;
    }
    guide[i] = sum / total;
}
