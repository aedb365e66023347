// The coarse texels where the lit maps keep indirect irradiance.
#ifndef LANTHORN_EMC_LIT_COARSE_GLSL
#define LANTHORN_EMC_LIT_COARSE_GLSL

#include "gi_module/techniques/emc/gather/point_lists.glsl"

#ifndef MAX_MAPS
#define MAX_MAPS 40
#endif

uniform usamplerBuffer coarse_index;     // by place: number + 1
uniform samplerBuffer coarse_points;     // by number
uniform samplerBuffer coarse_irradiance; // by number; a < 0: nothing is known
uniform int coarse_resolution;
uniform vec4 map_centres[MAX_MAPS];

// Takes the coarse texel (x, y) of `face` into the weighted mean, if it lies on the surface of the point; `tolerance` in metres.
void add_coarse(ivec2 p, int face, vec3 x, vec3 n, float tolerance, float weight, inout vec4 sum) {
    bool inside = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, ivec2(coarse_resolution)));
    p = clamp(p, ivec2(0), ivec2(coarse_resolution - 1));
    uint number = texelFetch(coarse_index, (face * coarse_resolution + p.y) * coarse_resolution + p.x).r;
    int k = max(int(number) - 1, 0);
    vec4 point = texelFetch(coarse_points, k);
    vec4 e = texelFetch(coarse_irradiance, k);
    vec3 m = point_normal(point);
    float off = 0.5 * abs(dot(point.xyz - x, n + m));
    bool same = inside && number != 0u && e.a >= 0.0 && dot(n, m) > 0.9 && off < tolerance;
    sum += same ? vec4(e.rgb, 1.0) * weight : vec4(0.0);
}

// How far off a surface what lies on it may seem to be at `x`.
float coarse_tolerance(vec3 x, int face) { return 0.5 * distance(x, map_centres[face / 6].xyz) / float(coarse_resolution); }

#endif
