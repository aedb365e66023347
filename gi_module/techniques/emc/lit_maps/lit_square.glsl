// What the square of a lit texel shows of its environment map. Needs intersection.glsl.
#ifndef LANTHORN_EMC_LIT_SQUARE_GLSL
#define LANTHORN_EMC_LIT_SQUARE_GLSL

#include "lit_maps.glsl"

struct LitSquare {
    ivec3 middle;  // the map's texel
    bool shows;    // a surface is there
    vec3 o;        // its point, from the map's centre
    vec3 n;        // its normal
};

// Whether a plane g at the point `o` from the map's centre is that of the surface there.
bool on_plane(vec3 o, vec3 n, vec3 g) {
    return g != vec3(0.0) && dot(plane_normal(g), n) > kLeastLitCosine &&
           abs(dot(o, g) - 1.0) < lit_tolerance(o) * length(g);
}

// Where the lit texel's own middle lies on the plane of the map's texel there, between the map's texels; unless that is behind
// what one of them shows, where it would be dark, or far off: a plane seen edge on may not be met there at all.
LitSquare square_of(ivec3 p) {
    ivec3 middle = lit_middle(p);
    vec3 g = plane_at(middle);
    vec3 u = cube_direction(p.z % 6, (vec2(p.xy) + 0.5) / float(lit_resolution));
    vec3 o = g == vec3(0.0) ? u * scene_diagonal : u / max(dot(u, g), 1e-20);
    vec3 own = texel_point(middle, g);
    bool behind = g != vec3(0.0) && !(dot(o, o) < 4.0 * dot(own, own));
    for (int k = 0; k < 4; ++k) {
        ivec2 beside = max(middle.xy - ivec2(k & 1, k >> 1), ivec2(0));
        behind = behind || dot(o, plane_at(ivec3(beside, middle.z))) > 1.00001;
    }
    return LitSquare(middle, g != vec3(0.0), behind ? own : o, plane_normal(g));
}

// The mean over what of its square lies on its surface.
vec3 albedo_of(ivec3 p, LitSquare square) {
    ivec2 first = p.xy * map_resolution / lit_resolution;
    ivec2 end = (p.xy + 1) * map_resolution / lit_resolution;
    vec4 sum = vec4(kept_albedo(texelFetch(environment_albedo, square.middle, 0)), 1.0) * 1e-3;
    for (int j = first.y; j < end.y; ++j) {
        for (int i = first.x; i < end.x; ++i) {
            vec3 beside = plane_at(ivec3(i, j, p.z));
            float same = on_plane(square.o, square.n, beside) ? 1.0 : 0.0;
            sum += same * vec4(kept_albedo(texelFetch(environment_albedo, ivec3(i, j, p.z), 0)), 1.0);
        }
    }
    return sum.rgb / sum.a;
}

#endif
