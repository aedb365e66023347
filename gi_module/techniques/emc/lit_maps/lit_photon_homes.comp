#version 450 core
// The coarse texel that counts the photons of each lit texel of the listed blocks, on the same surface. BESIDE 0: that of its own
// block; where it shows another surface, the lit texel is listed. 1: of listed lit texels, the nearest of those beside it.
layout(local_size_x = 256) in;

#include "lit_points.glsl"
#include "lit_photon_parts.glsl"
#if !BESIDE
#include "gi_module/techniques/emc/gather/entry_list.glsl"
#endif

layout(std430, binding = 4) buffer Homes { uint homes[]; };  // by place: place of the coarse texel + 1; 0: none
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform usamplerBuffer coarse_index;  // by place: number + 1
uniform samplerBuffer coarse_points;  // by number
uniform int coarse_resolution;
uniform vec4 map_centres[MAX_MAPS];
#if !BESIDE
uniform uint blocks;                  // all of them; 0: those listed
#endif
uniform samplerBuffer parts;          // by place: m^2

// Its parts count with those of another, then.
void set_home(int place, uint home) {
    uint before = homes[place];
    bool other = before != home;
    while (other) {
        vec4 area = texelFetch(parts, place);
        count_parts(before, area, true);
        count_parts(home, area, false);
        homes[place] = home;
        other = false;
    }
}

void main() {
    uint i = work_item();
#if BESIDE
    if (i >= listed_count) return;
    int place = int(list[i]);
#else
    if (i >= (blocks > 0u ? blocks : listed_count) * kBlockTexels) return;
    int place = lit_place(texel_of_block(BLOCK_OF(i / kBlockTexels), int(i % kBlockTexels)));
#endif
    vec4 point = texelFetch(lit_points, place);
    bool lit = is_lit(point);
    vec3 n = point_normal(point);
    int face = place / (lit_resolution * lit_resolution);
    ivec2 p = ivec2(place % lit_resolution, place / lit_resolution % lit_resolution);
    int side = lit_resolution / coarse_resolution;
    float tolerance = 0.5 * distance(point.xyz, map_centres[face / 6].xyz) / float(coarse_resolution);
    uint home = 0u;
    float nearest = 3.4e38;
    for (int k = 0; k < (BESIDE != 0 ? 9 : 1); ++k) {
        ivec2 q = p / side + (BESIDE != 0 ? ivec2(k % 3, k / 3) - 1 : ivec2(0));
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, ivec2(coarse_resolution)));
        q = clamp(q, ivec2(0), ivec2(coarse_resolution - 1));
        int at = (face * coarse_resolution + q.y) * coarse_resolution + q.x;
        uint number = texelFetch(coarse_index, at).r;
        vec4 other = texelFetch(coarse_points, max(int(number) - 1, 0));
        vec3 m = point_normal(other);
        vec3 apart = other.xyz - point.xyz;
        bool fits = inside && number != 0u && dot(n, m) > 0.9 && 0.5 * abs(dot(apart, n + m)) < tolerance;
        float far = dot(apart, apart);
        bool take = fits && far < nearest;
        nearest = take ? far : nearest;
        home = take ? uint(at) + 1u : home;
    }
#if BESIDE
    set_home(place, home);
#else
    bool lists = lit && home == 0u;
    if (lists) list_entry(uint(place));
    if (!lists) set_home(place, lit ? home : 0u);
#endif
}
