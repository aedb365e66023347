#version 450 core
// Of the parts of the lit texels in the listed blocks: the lit texel that a photon that lands there would find, and how large they
// are. What another map shows is counted there.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_lookup.glsl"

layout(std430, binding = 4) writeonly buffer Found { uvec4 found[]; };  // by place: the lit texel of each part; kUnlit: none
layout(std430, binding = 5) writeonly buffer Areas { vec4 areas[]; };   // by place: m^2 of each part
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

const int kParts = 2;             // a side of a lit texel
const float kLeastFacing = 0.02;  // cosine: beyond it a texel tells nothing of the area that it shows

void main() {
    uint item = work_item();
    if (item >= listed_count * kBlockTexels) return;
    ivec3 p = texel_of_block(int(list[item / kBlockTexels]), int(item % kBlockTexels));
    int place = lit_place(p);
    int slot = p.z / 6;
    bool lit = is_lit(texelFetch(lit_points, place));
    float width = 2.0 / float(kParts * lit_resolution);
    uvec4 which = uvec4(kUnlit);
    vec4 area = vec4(0.0);
    int k = 0;
    while (lit && k < kParts * kParts) {
        vec2 at = vec2(p.xy) + (vec2(k % kParts, k / kParts) + 0.5) / float(kParts);
        vec3 u = cube_direction(p.z % 6, at / float(lit_resolution));
        vec3 g = plane_at(map_texel(slot, u));
        float inverse = dot(u, g);
        float u2 = dot(u, u);
        vec3 o = u / max(inverse, 1e-20);
        vec3 n = plane_normal(g);
        uint there = inverse > 0.0 ? shown_place_of(map_centres[slot].xyz + o, -n, n) : kUnlit;
        bool here = there < kListed && int(there) / (6 * lit_resolution * lit_resolution) == slot;
        float facing = -dot(n, u) * inversesqrt(u2);
        which[k] = here ? there : kUnlit;
        // Solid angle times squared distance over cosine.
        area[k] = width * width * inversesqrt(u2) / u2 * dot(o, o) / max(facing, kLeastFacing);
        ++k;
    }
    found[place] = which;
    areas[place] = area;
}
