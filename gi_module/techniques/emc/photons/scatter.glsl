// What emission and bounces share: the numbers of a scattering event and how far from its surface a ray starts.
#ifndef LANTHORN_EMC_SCATTER_GLSL
#define LANTHORN_EMC_SCATTER_GLSL

// Offsets are shares of the diagonal of the scene, or of what of it lies about the camera: well under a texel's footprint, well over fp32's steps.
float origin_offset() { return 2e-5 * local_length; }
float ray_start() { return 2e-5 * local_length; }

// Odd 32-bit multipliers: the fractional parts of square roots of primes, two a bounce. i * multiplier modulo 2^32 is a
// Kronecker sequence, exact for every i, that fills the hemisphere more evenly than independent numbers.
const uvec2 kScatterSteps[9] = uvec2[9](uvec2(1779033703u, 3144134277u), uvec2(1013904241u, 2773480763u),
                                        uvec2(1359893119u, 2600822925u), uvec2(528734635u, 1541459225u),
                                        uvec2(3418070365u, 1654270251u), uvec2(2438529371u, 355462361u),
                                        uvec2(1731405415u, 4290775857u), uvec2(2394180231u, 1203062813u),
                                        uvec2(654170437u, 3679108389u));

// Four numbers in 0..1 of photon `index` scattered after `bounce` reflections: xy the direction, z free, w the choice of
// maps, which does not depend on the bounce. The same in every frame.
vec4 scatter_numbers(uint seed, uint index, uint bounce) {
    uvec2 u = index * kScatterSteps[bounce] + pcg4d(uvec4(seed, bounce, 23u, 29u)).xy;
    vec2 free = random4(seed, index, bounce, 0u).zw;
    return vec4(vec2(u >> 8u) * (1.0 / 16777216.0), free.x, random4(seed, index, 0u, 7u).w);
}

#endif
