#version 450 core
// One level of a variance-guided a-trous filter (Schied et al. 2017, eqs. 3-5) over the grid of points: by plane, normal and
// luminance.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gather_surface.glsl"
#include "gather_trust.glsl"
#include "gather_links.glsl"

layout(std430, binding = 4) writeonly buffer Filtered { vec4 filtered[]; };

uniform samplerBuffer points;
uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform samplerBuffer guide;  // mean luminance of rays and its mean square
uniform ivec2 grid;
uniform int first_item;
uniform usamplerBuffer cuts;  // links that a wall stands in
uniform samplerBuffer known;  // rays behind a point's irradiance
uniform int level;
uniform float narrowed;  // GatherFilter::Width
uniform vec2 narrowing;  // rays from which on a point is narrower than that, and 1 over how many more until it is narrow
uniform bool narrows;    // whether a narrow point does without this level

const float kSure = 0.1, kUnsure = 0.3;

void main() {
    int i = first_item + int(work_item());
    if (i >= grid.x * grid.y) return;
    ivec2 p = ivec2(i % grid.x, i / grid.x);
    vec4 point = texelFetch(points, i);
    vec3 n = point_normal(point);
    float slack = 1e-4 * length(point.xyz);
    vec2 here = texelFetch(guide, i).rg;
    float rays = texelFetch(known, i).r;
    if (level >= filter_levels(rays)) {
        filtered[i] = texelFetch(irradiance, i);
        return;
    }
    int step_width = 1 << level;
    float deviation = sqrt(max(here.y - here.x * here.x, 0.0) / max(rays, 1.0));
    // Of the mean: many rays of which few find the light would leave blotches.
    float sure = clamp((kUnsure * here.x - deviation) / max((kUnsure - kSure) * here.x, 1e-30), 0.0, 1.0);
    float narrow = max(narrowed, sure * clamp((rays - narrowing.x) * narrowing.y, 0.0, 1.0));
    float least_sigma = mix(4.0, 2.0, narrow);
    float share = narrows ? 1.0 - narrow : 1.0;  // of this level in what it gives; the rest is as it was
    float stop = 1.0 / max(sigma_of(rays, least_sigma) * deviation, 1e-3 * here.x + 1e-30);
    uint walls = texelFetch(cuts, i).r;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; ++k) {
        ivec2 off = ivec2(k % 3 - 1, k / 3 - 1);
        ivec2 q = p + step_width * off;
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, grid));
        q = clamp(q, ivec2(0), grid - 1);
        int at = q.y * grid.x + q.x;
        vec4 e = texelFetch(irradiance, at);
        vec4 other = texelFetch(points, at);
        float w = (off.x == 0 ? 0.5 : 0.25) * (off.y == 0 ? 0.5 : 0.25);
        w *= inside && e.a >= 0.0 && !is_cut(walls, level, k) ? same_surface(point.xyz, n, other.xyz, point_normal(other), slack) : 0.0;
        w *= exp(-min(abs(texelFetch(guide, at).r - here.x) * stop, 60.0));
        // The more rays, the less noise.
        w *= min(texelFetch(known, at).r, 64.0);
        sum += w * vec4(e.rgb, 1.0);
    }
    vec4 own = texelFetch(irradiance, i);
    vec3 mean = sum.rgb / max(sum.a, 1e-20);
    filtered[i] = sum.a > 1e-20 ? vec4(own.a < 0.0 ? mean : mix(own.rgb, mean, share), 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
