// A blended surface (alphaMode BLEND) as a screen: each place of it is solid or open, solid with the chance
// of its alpha. A hash of the place decides, so that rays, shadows and maps find the same screen in every
// frame: hashed alpha testing (Wyman and McGuire 2017, section 3; here of render space, in cells that grow
// with the coordinates). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_ALPHA_COVERAGE_H
#define LANTHORN_ALPHA_COVERAGE_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

#define LANTHORN_SHARED inline
namespace lanthorn {
#else
#define LANTHORN_SHARED
#endif

// From this alpha on a camera sees a surface as it sees an opaque one, with all light that falls on it.
const float kSolidAlpha = 0.98f;

// 0..1: at `position` (render space) what has more alpha than this is met. PCG3D (Jarzynski and Olano 2020)
// of the cell, a 4096th of the largest coordinate's power of two.
LANTHORN_SHARED float alpha_threshold(vec3 position) {
#ifdef __cplusplus
    using glm::abs, glm::exp2, glm::floor, glm::log2, glm::max, glm::uvec3;
#endif
    vec3 size = abs(position);
    float largest = max(max(size.x, size.y), max(size.z, 1e-30f));
    // Rounded: planes at round coordinates are in the middle of cells.
    vec3 cell = floor(position * exp2(12.0f - floor(log2(largest))) + 0.5f);
    uvec3 v = uvec3(ivec3(cell)) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v = v ^ (v >> 16u);
    v.x += v.y * v.z;
    return float(v.x >> 8u) * (1.0f / 16777216.0f);
}

// The same in cells of `cell` metres, for pictures of a surface that have to agree with each other on where
// it is open although their texels are wider than the cells above. Neighbouring cells take the values of a
// lattice (Roberts 2018, R3), so that of a few cells, too, as many are open as alpha says.
LANTHORN_SHARED float coarse_alpha_threshold(vec3 position, float cell) {
#ifdef __cplusplus
    using glm::dot, glm::floor, glm::fract, glm::mod;
#endif
    vec3 place = mod(floor(position / cell + 0.5f), vec3(4096.0f));
    return fract(dot(place, vec3(0.8191725134f, 0.6710436067f, 0.5497004779f)));
}

#undef LANTHORN_SHARED
#ifdef __cplusplus
}  // namespace lanthorn
#endif
#endif
