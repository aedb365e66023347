// Unit vectors in two numbers: octahedral mapping (Meyer et al. 2010, "On floating-point normal vectors").
#ifndef LANTHORN_OCTAHEDRAL_GLSL
#define LANTHORN_OCTAHEDRAL_GLSL

// Unit vector to -1..1 squared.
vec2 octahedral_encode(vec3 n) {
    n /= max(abs(n.x) + abs(n.y) + abs(n.z), 1e-20);
    vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return n.z >= 0.0 ? n.xy : folded;
}

// Back to the vector's direction; |x| + |y| + |z| = 1.
vec3 octahedral_vector(vec2 e) {
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -fold : fold;
    n.y += n.y >= 0.0 ? -fold : fold;
    return n;
}

vec3 octahedral_decode(vec2 e) { return normalize(octahedral_vector(e)); }

#endif
