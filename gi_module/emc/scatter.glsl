// What emission and bounces share: the numbers of a scattering event and how far from its surface a ray starts.
#ifndef LANTHORN_EMC_SCATTER_GLSL
#define LANTHORN_EMC_SCATTER_GLSL

// Offsets are shares of the scene's diagonal: well under a texel's footprint, well over fp32's steps.
float origin_offset() { return 2e-5 * scene_diagonal; }
float ray_start() { return 1e-4 * scene_diagonal; }

// Four numbers in 0..1 of photon `index` at `bounce`: xy the direction, w the choice of maps (bounce-independent).
vec4 scatter_numbers(uint seed, uint index, uint bounce) {
    vec4 u = random4(seed, index, bounce, 0u);
    u.w = random4(seed, index, 0u, 7u).w;
    return u;
}

#endif
