// Ray-geometry intersection with multiple environment maps (Yao et al. 2010, sec. 5).
//
// A texel of `environment_planes` holds g = n / dot(n, p), where p is the surface point relative to the map's centre and n its
// normal: the distance of that texel's *plane* along a unit direction w is 1 / dot(w, g). 0 where there is nothing.
//
// Along a ray from x, seen from the centre, write w(phi) = a cos(phi) + b sin(phi), phi the angle turned since x. Then
//   F(phi) = 1/D(w) - 1/|ray point| = cos(phi) (dot(a,g) - 1/|o|) + sin(phi) (dot(b,g) + cot(theta)/|o|),   o = x - centre,
// is linear in (cos, sin) inside one texel: negative in front of what the map sees, positive behind it.
#ifndef LANTHORN_EMC_INTERSECTION_GLSL
#define LANTHORN_EMC_INTERSECTION_GLSL

#include "engine/render/cube.glsl"
#include "engine/render/octahedral.glsl"
#include "engine/render/kept_albedo.glsl"

#ifndef SEARCH_SECANT
#define SEARCH_SECANT 0  // 1: the paper's false position, 0: bracketed march
#endif
#ifndef MAX_MAPS
#define MAX_MAPS 40
#endif

uniform usampler2DArray environment_planes;
uniform sampler2DArray environment_albedo;
uniform vec4 map_centres[MAX_MAPS];  // xyz, render space
uniform int map_count;
uniform int map_resolution;
uniform vec3 map_fade;         // x: slot fading in, y: slot fading out (-1: none), z: share of photons that use the new one
uniform float march_step;      // radians
uniform float hit_threshold;   // epsilon of eq. 2
uniform int search_all_maps;   // 1: no early end when one map has seen the whole segment
uniform float scene_diagonal;
uniform float local_length;    // EnvironmentMaps::extent(): what tolerances are relative to
uniform vec3 scene_lower;      // the box around all geometry
uniform vec3 scene_upper;

struct MapHit {
#if SEARCH_SECANT
    vec3 point;  // from the map's centre
#endif
    float t;        // along the ray; < 0: none
    vec3 normal;    // unit, towards the map's centre
    ivec3 texel;
    bool certain;   // the map saw the origin and everything up to t (or to the segment's end without a hit)
};

ivec3 map_texel(int slot, vec3 w) {
    vec3 f = cube_face_uv(w);
    ivec2 p = clamp(ivec2(f.xy * float(map_resolution)), ivec2(0), ivec2(map_resolution - 1));
    return ivec3(p, slot * 6 + int(f.z));
}

// The surface point in the middle of a texel, relative to the map's centre.
vec3 texel_point(ivec3 texel, vec3 g) {
    vec3 u = cube_direction(texel.z % 6, (vec2(texel.xy) + 0.5) / float(map_resolution));
    float inverse = dot(u, g);
    return u / max(inverse, 1e-20);
}

// g of a texel; 0 where there is nothing. Kept in 8 bytes, since photons look all over the maps and wait for memory: x the
// octahedral normal, y the factor that takes the decoded vector to g, so that the plane passes through p exactly.
vec3 plane_of(uvec2 kept) { return octahedral_vector(unpackSnorm2x16(kept.x)) * uintBitsToFloat(kept.y); }
vec3 plane_at(ivec3 texel) { return plane_of(texelFetch(environment_planes, texel, 0).rg); }

// The raw distance |p| of a texel, 0 where there is nothing.
float distance_at(ivec3 texel, vec3 g) {
    vec3 u = cube_direction(texel.z % 6, (vec2(texel.xy) + 0.5) / float(map_resolution));
    return g == vec3(0.0) ? 0.0 : length(u) / max(dot(u, g), 1e-20);
}

vec3 plane_normal(vec3 g) { return -normalize(g); }

// Eq. 2: 1 - cos of the angle between the ray and the point found.
bool accepted(vec3 x, vec3 r, vec3 p, out float t) {
    vec3 v = p - x;
    float l = length(v);
    t = l;
    return l > 0.0 && 1.0 - dot(v, r) / l < hit_threshold;
}

// Marches w(phi) in equal angles until F changes from in front to behind, then closes in with the planes of the texels.
// Loops rather than branches hold the rare parts, so that a vector of photons skips them together.
// `first_only`: gives up at the first silhouette (type B), uncertain, instead of going on behind it.
MapHit march(int slot, vec3 x, vec3 r, float t_min, float t_max, const bool first_only) {
    MapHit hit;
    hit.t = -1.0;
    hit.normal = vec3(0.0);
    hit.texel = ivec3(0);
    vec3 o = x - map_centres[slot].xyz;
    float lo = max(length(o), 1e-6 * local_length);
    vec3 a = o / lo;
    float cos_theta = clamp(dot(a, r), -1.0, 1.0);
    vec3 b = r - a * cos_theta;
    float sin_theta = length(b);
    bool radial = sin_theta < 1e-4;  // through the centre: turned by as much as keeps the plane of (a, b) defined
    vec3 any_normal = normalize(abs(a.x) < 0.5 ? vec3(0.0, -a.z, a.y) : vec3(-a.y, a.x, 0.0));
    sin_theta = radial ? 1e-4 : sin_theta;
    b = radial ? any_normal : b / sin_theta;
    float inv_lo = 1.0 / lo;
    float cot = cos_theta / (lo * sin_theta);

    // (cos, sin) of phi at both ends; phi is in 0..pi, so its order is the reverse of the cosine's
    vec2 here = normalize(vec2(lo + t_min * cos_theta, t_min * sin_theta));
    vec2 end = normalize(vec2(lo + t_max * cos_theta, t_max * sin_theta));
    float arc = atan(here.x * end.y - here.y * end.x, dot(here, end));
    int steps = clamp(int(ceil(arc / march_step)), 1, 1024);
    float d_phi = arc / float(steps);
    vec2 turn = vec2(cos(d_phi), sin(d_phi));

    ivec3 texel = map_texel(slot, a * here.x + b * here.y);
    vec3 g = plane_at(texel);
    vec2 coefficients = vec2(dot(a, g) - inv_lo, dot(b, g) + cot);
    float f = dot(here, coefficients);
    hit.certain = f <= 0.0;
    vec2 low = here;
    vec2 start = here;
    vec3 g_low = g;
    int i = 0;
    while (i < steps && hit.t < 0.0) {
        float f_before = f;
        bool bracket = false;
        while (i < steps && !bracket) {
            low = here;
            g_low = g;
            f_before = f;
            here = vec2(here.x * turn.x - here.y * turn.y, here.y * turn.x + here.x * turn.y);
            texel = map_texel(slot, a * here.x + b * here.y);
            g = plane_at(texel);
            f = dot(here, vec2(dot(a, g) - inv_lo, dot(b, g) + cot));
            // A surface may end between two looks: also a bracket if the ray has gone through the plane of the look before.
            bool crossed = dot(here, vec2(dot(a, g_low) - inv_lo, dot(b, g_low) + cot)) > 0.0;
            bracket = f_before <= 0.0 && (f > 0.0 || crossed);
            hit.certain = hit.certain && (f <= 0.0 || bracket);
            ++i;
        }
        if (!bracket) break;
        // Cut the ray with a texel's plane (exact inside it), look there, keep the bracket.
        vec2 high = here;
        vec3 g_high = g;
        vec2 root = here;
        vec3 g_root = g;
        for (int k = 0; k < 4; ++k) {
            vec2 cut = normalize(vec2(dot(b, g_high) + cot, inv_lo - dot(a, g_high)));
            cut = cut.y < 0.0 ? -cut : cut;
            vec2 cut_low = normalize(vec2(dot(b, g_low) + cot, inv_lo - dot(a, g_low)));
            cut_low = cut_low.y < 0.0 ? -cut_low : cut_low;
            bool high_fits = cut.x <= low.x && cut.x >= high.x;
            bool low_fits = cut_low.x <= low.x && cut_low.x >= high.x;
            root = high_fits ? cut : low_fits ? cut_low : normalize(low + high);
            texel = map_texel(slot, a * root.x + b * root.y);
            g_root = plane_at(texel);
            float f_root = dot(root, vec2(dot(a, g_root) - inv_lo, dot(b, g_root) + cot));
            bool past = f_root > 0.0;
            high = past ? root : high;
            g_high = past ? g_root : g_high;
            low = past ? low : root;
            g_low = past ? g_low : g_root;
            if (abs(f_root) * lo < 1e-5) break;
        }
        // Beside a concave edge the texel may show one wall where the ray meets the other: the nearer plane is the surface.
        vec3 own_point = texel_point(texel, g_root);
        vec2 within = cube_face_uv(a * root.x + b * root.y).xy * float(map_resolution) - vec2(texel.xy) - 0.5;
        ivec2 towards = ivec2(within.x < 0.0 ? -1 : 1, within.y < 0.0 ? -1 : 1);
        ivec3 own = texel;
        for (int k = 0; k < 2; ++k) {
            ivec3 beside = own;
            beside.xy = clamp(own.xy + (k == 0 ? ivec2(towards.x, 0) : ivec2(0, towards.y)), ivec2(0), ivec2(map_resolution - 1));
            vec3 g_beside = plane_at(beside);
            bool concave = dot(own_point, g_beside) < 0.999 && dot(texel_point(beside, g_beside), g_root) < 0.999;
            vec2 cut = normalize(vec2(dot(b, g_beside) + cot, inv_lo - dot(a, g_beside)));
            cut = cut.y < 0.0 ? -cut : cut;
            // The root itself may be where the ray meets that plane, beside a texel that shows the other.
            bool nearer = concave && cut.y * root.x - cut.x * root.y < 1e-6 && cut.x <= start.x;
            root = nearer ? cut : root;
            g_root = nearer ? g_beside : g_root;
            texel = nearer ? beside : texel;
        }
        vec3 w = a * root.x + b * root.y;
        float inv_d = dot(w, g_root);
        float t = 0.0;
        vec3 normal = plane_normal(g_root);
        if (inv_d > 0.0 && accepted(x, r, map_centres[slot].xyz + w / inv_d, t) && t >= t_min && t <= t_max &&
            dot(normal, r) < 0.0) {
            hit.t = t;
            hit.normal = normal;
            hit.texel = texel;
        } else {
            hit.certain = false;  // a silhouette (type B): the ray goes behind something
        }
        if (first_only) break;
    }
    return hit;
}

MapHit march(int slot, vec3 x, vec3 r, float t_min, float t_max) { return march(slot, x, r, t_min, t_max, false); }

#if SEARCH_SECANT
// What a map shows along `l`, from its centre; false: nothing.
bool shown_point(int slot, vec3 l, out ivec3 texel, out vec3 g, out vec3 p) {
    texel = map_texel(slot, l);
    g = plane_at(texel);
    float d = distance_at(texel, g);
    p = normalize(l) * d;
    return d > 0.0;
}

// The false position of Yao et al. 2010, sec. 5.1 and Fig. 5, after Szirmay-Kalos et al. 2005. Of two points that the map shows (A along
// the ray's own direction and B' behind or before the ray's point B, then B' and C', ...) the line is taken for the surface where the ray
// crosses it, one of them overshot and one undershot as soon as there are both. The ray's start is none of them: a photon starts on the
// surface, where the search would find that again. On raw distances of the nearest texels.
MapHit secant(int slot, vec3 x, vec3 r, float t_min, float t_max) {
    MapHit hit;
    hit.t = -1.0;
    hit.certain = false;
    vec3 o = x - map_centres[slot].xyz;
    ivec3 texel;
    vec3 g, a, b;
    if (!shown_point(slot, r, texel, g, a)) return hit;  // type A
    float t = length(a) - dot(o, r);                     // B: the plane through A, perpendicular to r
    if (!shown_point(slot, o + r * t, texel, g, b)) return hit;
    bool a_over = true;  // the ray's far end lies behind A
    bool b_over = dot(o + r * t, o + r * t) > dot(b, b);
    vec3 across = cross(o, r);
    for (int i = 0; i < 5; ++i) {
        vec3 m = cross(b - a, across);
        float along = dot(m, r);
        float next = abs(along) > 1e-6 * length(m) ? dot(m, a - o) / along : t;
        t = next > t_min ? next : 0.5 * t;
        vec3 l = o + r * t;
        vec3 c;
        if (!shown_point(slot, l, texel, g, c)) return hit;
        bool c_over = dot(l, l) > dot(c, c);
        bool keep_a = c_over == b_over && c_over != a_over;
        a = keep_a ? a : b;
        a_over = keep_a ? a_over : b_over;
        b = c;
        b_over = c_over;
    }
    vec3 normal = plane_normal(g);
    float found;
    // The photon lands on the texel's plane, not on the ray: off it, it would start behind a wall.
    hit.point = b / max(dot(b, g), 1e-20);
    if (accepted(x, r, map_centres[slot].xyz + hit.point, found) && found >= t_min && found <= t_max && dot(normal, r) < 0.0) {
        hit.t = found;
        hit.normal = normal;
        hit.texel = texel;
    }
    return hit;
}
#endif

struct SceneHit {
    bool found;
    vec3 position;
    vec3 normal;
    vec3 albedo;
    vec4 kept;  // texel that it is of (kept_albedo.glsl)
    int slot;
    float t;
};

// Whether photon `u` (its own fixed number in 0..1) uses this slot while one map fades into another.
bool slot_in_use(int slot, float u) {
    if (float(slot) == map_fade.x) return u < map_fade.z;
    if (float(slot) == map_fade.y) return u >= map_fade.z;
    return true;
}

// Where the ray has left the box around all geometry for sure: a march must end well behind the last wall to see it.
float scene_exit(vec3 x, vec3 r) {
    vec3 inverse = 1.0 / mix(r, vec3(1e-20), lessThan(abs(r), vec3(1e-20)));
    vec3 far = max((scene_lower - x) * inverse, (scene_upper - x) * inverse);
    return max(min(far.x, min(far.y, far.z)), 0.0) + 0.05 * scene_diagonal;
}

bool sees(int slot, vec3 x) {
    vec3 o = x - map_centres[slot].xyz;
    return dot(o, plane_at(map_texel(slot, o))) <= 1.0;
}

const float kSideTexels = 1.5;
const float kSideSlack = 1e-5;  // of the distance, for rounding

// Whether what a texel shows, of plane g, stands on a surface of normal n at `o` from the map's centre like a wall on a floor: not
// where the surface bends and goes on.
bool stands_on(ivec3 texel, vec3 g, vec3 o, vec3 n) {
    return dot(texel_point(texel, g) - o, n) > 0.3 / float(map_resolution) * length(o) && abs(dot(g, n)) < 0.9 * length(g);
}

// Whether a sheet that stands on a surface of normal n hides a point of it, at `o` from the map's centre. Where the sheet is thinner
// than a texel, the point's own texel may show the surface on the other side, in the same plane: the texel beside it to where n
// points shows the sheet, and the point is behind that. Sheets lower than such texels are passed over.
bool sheet_hides(int slot, vec3 o, vec3 n) {
    float d2 = max(dot(o, o), 1e-30);
    vec3 up = n - o * (dot(n, o) / d2);
    ivec3 texel = map_texel(slot, o + up * (kSideTexels * 2.0 / float(map_resolution) * sqrt(d2 / max(dot(up, up), 1e-20))));
    vec3 g = plane_at(texel);
    return dot(o, g) > 1.0 + kSideSlack && stands_on(texel, g, o, n);
}

// Whether the map sees a point of a surface of normal n (0: one in the open), from the side that it lies on.
// A loop: most that are asked first see it.
bool sees_side(int slot, vec3 x, vec3 n) {
    bool seen = sees(slot, x);
    bool asks = seen;
    while (asks) {
        seen = !sheet_hides(slot, x - map_centres[slot].xyz, n);
        asks = false;
    }
    return seen;
}

// Asks one map alone: the first that sees the origin, on a surface of normal n (0: in the open), `hint` ahead, on whose side that is
// if it is `known`. `settled`: it saw the whole segment, so no other map can
// know better. Else `hint` is the map after it, for the next call. No loop over maps or silhouettes, in which a vector of
// photons would wait for its slowest; four photons in five are settled at once.
SceneHit intersect_next(vec3 x, vec3 n, vec3 r, float t_min, inout int hint, bool known, float u, out bool settled) {
    int slot = hint;
    bool seen = false;
    for (int j = 0; j < map_count && !seen; ++j) {
        slot = hint + j;
        slot -= slot >= map_count ? map_count : 0;
        seen = slot_in_use(slot, u) && sees(slot, x);
        bool asks = seen && !(known && j == 0);
        while (asks) {
            seen = !sheet_hides(slot, x - map_centres[slot].xyz, n);
            asks = false;
        }
    }
    float t_max = scene_exit(x, r);
    MapHit hit = march(slot, x, r, t_min, t_max, true);
    SceneHit found;
    settled = seen && hit.certain;
    found.found = hit.t >= 0.0;
    found.t = hit.t >= 0.0 ? hit.t : t_max;
    found.normal = hit.normal;
    found.slot = slot;
    found.position = x + r * found.t;
    found.kept = texelFetch(environment_albedo, hit.texel, 0);
    found.albedo = kept_albedo(found.kept);
    hint = slot + 1 == map_count ? 0 : slot + 1;
    return found;
}

// Intersects the maps and keeps the nearest accepted hit (types A and B are dropped, C loses against D by distance).
// With the march, the maps that see the origin go first, `hint` ahead, and the search ends as soon as one map has seen the
// whole segment: nothing nearer can exist, and where it met nothing, nothing is. The others are asked after them.
SceneHit intersect_all(vec3 x, vec3 n, vec3 r, float t_min, int hint, float u) {
    SceneHit best;
    best.found = false;
    best.position = x;
    best.normal = vec3(0.0);
    best.albedo = vec3(0.0);
    best.kept = vec4(0.0);
    best.t = scene_exit(x, r);
    best.slot = 0;
    ivec3 texel = ivec3(0);
    bool ordered = SEARCH_SECANT == 0 && search_all_maps == 0;
    int rounds = ordered ? 2 : 1;
    int j = 0;
    while (j < rounds * map_count) {
        int slot = 0;
        bool ask = false;
        while (j < rounds * map_count && !ask) {
            slot = hint + j;
            slot -= (slot / map_count) * map_count;
            ask = slot_in_use(slot, u) && (!ordered || sees_side(slot, x, n) == (j < map_count));
            ++j;
        }
        if (!ask) break;
#if SEARCH_SECANT
        MapHit hit = secant(slot, x, r, t_min, best.t);
#else
        MapHit hit = march(slot, x, r, t_min, best.t);
#endif
        bool nearer = hit.t >= 0.0;
        best.found = best.found || nearer;
        best.t = nearer ? hit.t : best.t;
        best.normal = nearer ? hit.normal : best.normal;
        best.slot = nearer ? slot : best.slot;
#if SEARCH_SECANT
        best.position = nearer ? map_centres[slot].xyz + hit.point : best.position;
#endif
        texel = nearer ? hit.texel : texel;
        if (ordered && hit.certain) break;
    }
#if !SEARCH_SECANT
    best.position = x + r * best.t;
#endif
    best.kept = texelFetch(environment_albedo, texel, 0);
    best.albedo = kept_albedo(best.kept);
    return best;
}

#endif
