#version 450 core
// How large the parts are of the lit texels in the listed blocks, where a photon that lands there would find them. What another map
// shows is counted there.
layout(local_size_x = 256) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "lit_lookup.glsl"

#include "lit_photon_parts.glsl"

layout(std430, binding = 4) buffer Parts { vec4 parts[]; };  // by place: m^2 of each
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

const int kParts = 2;             // a side of a lit texel
uniform usamplerBuffer homes;  // by place: that of the coarse texel + 1; 0: none

const float kLeastFacing = 0.02;  // cosine: beyond it a texel tells nothing of the area that it shows

// Whether a photon that lands at x, on a surface of normal n, finds a lit texel of that map: it shows the point, and no sharper one does.
bool is_found_in(int slot, vec3 x, vec3 n) {
    vec3 o = x - map_centres[slot].xyz;
    float own = sharpness(o, n);
    vec3 m;
    bool found = own > 0.0 && met_there(lit_place(lit_texel(slot, o)), x, o, -n, n, m);
    int s = 0;
    while (found && s < map_count) {
        vec3 from = x - map_centres[s].xyz;
        float w = sharpness(from, n);
        bool sharper = s != slot && (w > own || (w == own && s < slot)) && slot_in_use(s, 0.0);
        bool asks = sharper;
        while (asks) {
            found = w > own && !met_there(lit_place(lit_texel(s, from)), x, from, -n, n, m);
            asks = false;
        }
        ++s;
    }
    return found;
}

void main() {
    uint item = work_item();
    if (item >= listed_count * kBlockTexels) return;
    ivec3 p = texel_of_block(int(list[item / kBlockTexels]), int(item % kBlockTexels));
    int place = lit_place(p);
    int slot = p.z / 6;
    bool lit = is_lit(texelFetch(lit_points, place));
    float width = 2.0 / float(kParts * lit_resolution);
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
        bool here = inverse > 0.0 && is_found_in(slot, map_centres[slot].xyz + o, n);
        float facing = -dot(n, u) * inversesqrt(u2);
        // Solid angle times squared distance over cosine.
        area[k] = here ? width * width * inversesqrt(u2) / u2 * dot(o, o) / max(facing, kLeastFacing) : 0.0;
        ++k;
    }
    vec4 before = parts[place];
    bool other = before != area;
    while (other) {
        uint home = texelFetch(homes, place).r;
        count_parts(home, before, true);
        count_parts(home, area, false);
        parts[place] = area;
        other = false;
    }
}
