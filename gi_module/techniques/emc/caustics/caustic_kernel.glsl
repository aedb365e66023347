// What a caustic photon adds to the irradiance around it.
#ifndef LANTHORN_EMC_CAUSTIC_KERNEL_GLSL
#define LANTHORN_EMC_CAUSTIC_KERNEL_GLSL

// Surfaces that are turned away by more (a cosine) are others.
const float kLeastTurn = 0.25;

// A photon's two texels, of PhotonHit, at a point with normal n. `thin`: a length that is nothing in the scene.
vec3 caustic_irradiance(vec4 place, vec4 load, vec3 photon_normal, vec3 x, vec3 n, float thin) {
    float inverse_h2 = 1.0 / max(place.w * place.w, 1e-30);
    float thickness = 0.25 * place.w + thin;
    vec3 d = place.xyz - x;
    float u = dot(d, d) * inverse_h2;
    // A chord of a round surface is square to the mean of the normals at its ends; of a plane, to both.
    float turn = dot(photon_normal, n);
    bool inside = u < 1.0 && abs(0.5 * dot(d, n + photon_normal)) < thickness && turn > kLeastTurn;
    // Epanechnikov's kernel, 1 over a disc; where the surface turns, more of it lies behind the same disc.
    return inside ? load.rgb * ((1.0 - u) * (0.63661977 * inverse_h2) * turn) : vec3(0.0);
}

#endif
