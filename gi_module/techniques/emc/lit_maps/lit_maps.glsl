// Lit texels: the texels of the environment maps at a lower resolution, each standing for the surface that the map's texel in its
// middle shows. Of the maps that see a surface, the sharpest alone keeps lit texels of it, a reserved one last. Needs intersection.glsl.
#ifndef LANTHORN_EMC_LIT_MAPS_GLSL
#define LANTHORN_EMC_LIT_MAPS_GLSL

#include "lit_hits.glsl"
#include "lit_points.glsl"

const float kLeastLitCosine = 0.9;  // between the normals of a point and of a lit texel of its surface
const float kLitThickness = 0.5;    // of a lit texel's width at distance 1 from the centre (2 / lit_resolution), halved

// Texels of a map that fall on a unit of surface at `o` from its centre, up to a factor: cos / d^3.
float sharpness(vec3 o, vec3 n) {
    float d2 = dot(o, o);
    return -dot(o, n) / (d2 * d2);
}

float lit_tolerance(vec3 o) { return kLitThickness * length(o) / float(lit_resolution); }

ivec3 lit_texel(int slot, vec3 o) {
    vec3 f = cube_face_uv(o);
    ivec2 p = clamp(ivec2(f.xy * float(lit_resolution)), ivec2(0), ivec2(lit_resolution - 1));
    return ivec3(p, slot * 6 + int(f.z));
}

// The map's texel that a lit texel stands for.
ivec3 lit_middle(ivec3 p) { return ivec3((2 * p.xy + 1) * map_resolution / (2 * lit_resolution), p.z); }

#endif
