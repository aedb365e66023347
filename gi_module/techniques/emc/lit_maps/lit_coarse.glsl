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

// Its number + 1, of that at (x, y) or the nearest one of `face`; 0: there is none.
uint coarse_number(ivec2 p, int face) {
    p = clamp(p, ivec2(0), ivec2(coarse_resolution - 1));
    return texelFetch(coarse_index, (face * coarse_resolution + p.y) * coarse_resolution + p.x).r;
}

// The same of that at (x, y), if it lies on the surface of a point; `tolerance` in metres.
uint number_on_surface(ivec2 p, int face, vec3 x, vec3 n, float tolerance) {
    bool inside = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, ivec2(coarse_resolution)));
    uint number = coarse_number(p, face);
    vec4 point = texelFetch(coarse_points, max(int(number) - 1, 0));
    vec3 m = point_normal(point);
    float off = 0.5 * abs(dot(point.xyz - x, n + m));
    return inside && dot(n, m) > 0.9 && off < tolerance ? number : 0u;
}

// Takes a coarse texel into the weighted mean, if there is one.
void add_number(uint number, float weight, inout vec4 sum) {
    vec4 e = texelFetch(coarse_irradiance, max(int(number) - 1, 0));
    sum += number != 0u && e.a >= 0.0 ? vec4(e.rgb, 1.0) * weight : vec4(0.0);
}

void add_coarse(ivec2 p, int face, vec3 x, vec3 n, float tolerance, float weight, inout vec4 sum) {
    add_number(number_on_surface(p, face, x, n, tolerance), weight, sum);
}

// Where the middle of a lit texel lies on its face, in coarse texels from the middle of the first.
vec2 coarse_position(ivec2 p, int texels_a_side) {
    return (vec2(p) + 0.5) * float(coarse_resolution) / float(texels_a_side) - 0.5;
}

// How far off a surface what lies on it may seem to be at `x`.
float coarse_tolerance(vec3 x, int face) { return 0.5 * distance(x, map_centres[face / 6].xyz) / float(coarse_resolution); }

#endif
