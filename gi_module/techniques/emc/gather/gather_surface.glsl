// Whether two points lie on one surface, as a weight.
#ifndef LANTHORN_EMC_GATHER_SURFACE_GLSL
#define LANTHORN_EMC_GATHER_SURFACE_GLSL

// A chord of a round surface is square to the mean of the normals at its ends; of a plane, to both. `slack`: m, what two points
// of one surface may be off for rounding alone.
float same_surface(vec3 x, vec3 n, vec3 y, vec3 m, float slack) {
    vec3 delta = y - x;
    float off = 0.5 * dot(n + m, delta);
    float plane = off * off / (0.01 * dot(delta, delta) + slack * slack);
    return smoothstep(0.8, 0.98, dot(n, m)) * exp2(-min(plane, 60.0));
}

const float kSomeSurface = 0.01;  // of same_surface(): less is another one

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

#endif
