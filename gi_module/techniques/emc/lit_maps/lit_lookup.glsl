// The lit texel that shows a point. Needs intersection.glsl.
#ifndef LANTHORN_EMC_LIT_LOOKUP_GLSL
#define LANTHORN_EMC_LIT_LOOKUP_GLSL

#include "lit_maps.glsl"
#include "lit_hits.glsl"

// Whether the lit texel at `place` shows the surface of a point, at `o` from the map's centre; `m`: its normal.
bool shows(int place, vec3 x, vec3 o, out vec3 m) {
    vec4 point = texelFetch(lit_points, place);
    m = point_normal(point);
    return is_lit(point) && abs(dot(x - point.xyz, m)) < lit_tolerance(o);
}

// Whether what stands on a lit texel's surface, however thin it is, parts the point at `o` from the map's centre from it.
bool beyond_a_sheet(int place, vec3 o) {
    uvec4 sheets = floatBitsToUint(texelFetch(lit_points, lit_sheets + place));
    return max(dot(o, plane_of(sheets.xy)), dot(o, plane_of(sheets.zw))) > 1.0 + kSideSlack;
}

// Whether a ray in direction d may have met at x, at `o` from the map's centre, what the lit texel at `place` shows. Of a surface that it met the normal n is known, or else 0.
bool met_there(int place, vec3 x, vec3 o, vec3 d, vec3 n, out vec3 m) {
    bool fits = shows(place, x, o, m);
    return fits && dot(m, d) < 0.0 && (n == vec3(0.0) || dot(m, n) > kLeastLitCosine) && !beyond_a_sheet(place, o);
}

// Of the maps that show the surface at x with normal n less sharply than `sharper`, the sharpest, and how sharp; -1: none is left.
int next_sharpest(vec3 x, vec3 n, inout float sharper) {
    int best = -1;
    float most = 0.0;
    for (int s = 0; s < map_count; ++s) {
        float w = sharpness(x - map_centres[s].xyz, n);
        bool better = w > most && w < sharper && slot_in_use(s, 0.0);
        best = better ? s : best;
        most = better ? w : most;
    }
    sharper = most;
    return best;
}

// What lit_place_of() asks first, of a point whose normal is known: the sharpest map alone. kUnlit: the others are to be asked.
uint sharpest_place_of(vec3 x, vec3 d, vec3 n) {
    float sharper = 3.4e38;
    int s = next_sharpest(x, n, sharper);
    vec3 o = x - map_centres[max(s, 0)].xyz;
    int place = lit_place(lit_texel(max(s, 0), o));
    vec3 m;
    return s >= 0 && met_there(place, x, o, d, n, m) ? uint(place) : kUnlit;
}

// The same of all maps, the sharpest first: the lit texel in whose own square the point, whose normal is known, lies.
uint shown_place_of(vec3 x, vec3 d, vec3 n) {
    uint found = kUnlit;
    vec3 m;
    float sharper = 3.4e38;
    int s = next_sharpest(x, n, sharper);
    while (s >= 0 && found == kUnlit) {
        vec3 o = x - map_centres[s].xyz;
        int place = lit_place(lit_texel(s, o));
        found = met_there(place, x, o, d, n, m) ? uint(place) : kUnlit;
        s = next_sharpest(x, n, sharper);
    }
    return found;
}

// The place of the lit texel of a point that a ray in direction d has met: of the sharpest map that has one. At rims, where the
// nearest texels show what lies beside, the nearest one around them on the same surface. `n`: the point's normal, 0: not known.
// With a normal the first map that is asked has it as a rule; without, all are asked.
uint lit_place_of(vec3 x, vec3 d, vec3 n) {
    float most = 0.0;
    uint found = kUnlit;
    vec3 m;
    if (n != vec3(0.0)) {
        found = shown_place_of(x, d, n);
    } else {
        for (int s = 0; s < map_count; ++s) {
            vec3 o = x - map_centres[s].xyz;
            int place = lit_place(lit_texel(s, o));
            bool fits = slot_in_use(s, 0.0) && met_there(place, x, o, d, n, m);
            float w = fits ? sharpness(o, m) : 0.0;
            found = w > most ? uint(place) : found;
            most = max(w, most);
        }
    }
    int s = 0;
    while (s < map_count && found == kUnlit) {
        vec3 o = x - map_centres[s].xyz;
        if (slot_in_use(s, 0.0) && (n == vec3(0.0) || (dot(o, n) < 0.0 && !sheet_hides(s, o, n)))) {
            ivec3 p = lit_texel(s, o);
            int k = 0;
            while (k < 9 && found == kUnlit) {
                ivec3 q = ivec3(clamp(p.xy + ivec2(k % 3, k / 3) - 1, ivec2(0), ivec2(lit_resolution - 1)), p.z);
                int place = lit_place(q);
                found = met_there(place, x, o, d, n, m) ? uint(place) : kUnlit;
                ++k;
            }
        }
        ++s;
    }
    return found;
}

#endif
