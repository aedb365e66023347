// Counter-based random numbers: a hash of (seed, index, bounce, dimension), the same in every frame (Yao et al. 2010, sec. 7).
// pcg4d, Jarzynski and Olano 2020, "Hash functions for GPU rendering".
#ifndef LANTHORN_RANDOM_GLSL
#define LANTHORN_RANDOM_GLSL

uvec4 pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Four numbers in [0, 1).
vec4 random4(uint seed, uint index, uint bounce, uint dimension) {
    return vec4(pcg4d(uvec4(seed, index, bounce, dimension)) >> 8u) * (1.0 / 16777216.0);
}

// An orthonormal basis around unit `n` (Duff et al. 2017); it jumps where s does. Not at n.z = 0, where walls stand: there the
// sign of a rounding error would turn the directions of all photons of a wall.
void basis_around(vec3 n, out vec3 t, out vec3 bt) {
    float s = n.z >= -1e-3 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    t = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    bt = vec3(b, s + n.y * n.y * a, -n.y);
}

// A direction about unit `n` with density cos/pi, from two numbers in [0, 1) (Malley's method).
vec3 cosine_direction(vec3 n, vec2 u) {
    vec3 t;
    vec3 bt;
    basis_around(n, t, bt);
    float r = sqrt(u.x);
    float phi = 6.28318530718 * u.y;
    return normalize(t * (r * cos(phi)) + bt * (r * sin(phi)) + n * sqrt(max(1.0 - u.x, 0.0)));
}

#endif
