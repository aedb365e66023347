// Which surfaces a candidate sees, by its map.
#ifndef LANTHORN_EMC_SEEN_FROM_GLSL
#define LANTHORN_EMC_SEEN_FROM_GLSL

#include "engine/render/cube.glsl"

uniform sampler2DArray candidate_planes;  // n / dot(n, p), distance (< 0: a back, 0: nothing); layer = 6 * candidate + face
uniform int resolution;
layout(std430, binding = 0) readonly buffer Centres { vec4 centres[]; };

// True if x, on a surface of normal n, is seen from the candidate: the surface faces it, and x's distance agrees with the
// plane that its texel shows, to a texel's footprint. Of a wall thinner than that, one side alone faces it.
bool seen_from(int candidate, vec3 x, vec3 n) {
    vec3 d = x - centres[candidate].xyz;
    if (!(dot(d, n) < 0.0)) {
        return false;
    }
    float l = length(d);
    vec3 f = cube_face_uv(d);
    ivec2 p = clamp(ivec2(f.xy * float(resolution)), ivec2(0), ivec2(resolution - 1));
    vec4 plane = texelFetch(candidate_planes, ivec3(p, candidate * 6 + int(f.z)), 0);
    float along = dot(d, plane.xyz);  // |x| / distance of the texel's plane along d
    float tolerance = 2.0 / float(resolution);
    return plane.w > 0.0 && along > 0.0 && along < 1.0 + tolerance && l < plane.w * (1.0 + 4.0 * tolerance);
}

#endif
