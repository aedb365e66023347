#version 450 core
// What the listed lit texels reflect: B = albedo (E0 + E1), E1 interpolated between the coarse texels on the same surface. AT_RIMS
// 0: where none of the four around it fits, the texel is listed again. 1: the ring around those, at the rims of what is small.
layout(local_size_x = 256) in;

#include "lit_coarse.glsl"
#include "lit_points.glsl"
#if !AT_RIMS
#include "gi_module/techniques/emc/gather/entry_list.glsl"
#endif

layout(std430, binding = 5) writeonly buffer Radiosity { vec4 radiosity[]; };  // by place
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
// By place.
uniform samplerBuffer lit_albedo;
uniform samplerBuffer lit_direct;
#if !AT_RIMS
uniform usamplerBuffer lit_fits;  // lit_fits.comp
#endif

uniform float most_albedo;

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    ivec2 p = ivec2(place % lit_resolution, place / lit_resolution % lit_resolution);
    int face = place / (lit_resolution * lit_resolution);
    vec4 point = texelFetch(lit_points, place);
    if (!is_lit(point)) return;
    vec2 at = coarse_position(p, lit_resolution);
    ivec2 base = ivec2(floor(at));
    vec2 f = at - vec2(base);
    vec4 sum = vec4(0.0);
#if AT_RIMS
    vec3 n = point_normal(point);
    float tolerance = coarse_tolerance(point.xyz, face);
    int k = 0;
    while (k < 16 && sum.a == 0.0) {
        add_coarse(base + ivec2(k % 4, k / 4) - 1, face, point.xyz, n, 2.0 * tolerance, 1.0, sum);
        ++k;
    }
#else
    uint fits = texelFetch(lit_fits, place).r;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 w = mix(1.0 - f, f, vec2(corner)) + 1e-3;
        uint number = coarse_number(base + corner, face);
        add_number((fits >> k & 1u) != 0u ? number : 0u, w.x * w.y, sum);
    }
    if (sum.a == 0.0) list_entry(uint(place));
#endif
    vec3 e = texelFetch(lit_direct, place).rgb + (sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0));
    radiosity[place] = vec4(min(texelFetch(lit_albedo, place).rgb, vec3(most_albedo)) * e, 0.0);
}
