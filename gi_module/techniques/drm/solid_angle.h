// What a sample of a direct radiance map covers, by Frisvad et al. 2005, sec. 4. Included by C++ and by GLSL:
// keep to both.
//
// alpha: between the light's way and the normal where it arrives; theta': between that normal and the way on
// to the point that receives; r: metres between the two.
#ifndef LANTHORN_DRM_SOLID_ANGLE_H
#define LANTHORN_DRM_SOLID_ANGLE_H

#ifdef __cplusplus
#include <algorithm>
#include <cmath>

namespace lanthorn::gi {
#define DRM_FUNCTION inline
#else
#define DRM_FUNCTION
#endif

// Least cos(alpha) of eq. 13, which divides by it: light that grazes a surface lies on twenty times its own
// width of it at most.
const float kLeastCosAlpha = 0.05f;

// Eq. 12, where `gamma` is the picture's angle, `w` its texels a side, `b` metres from the light: square
// metres across the light's way. Of small texels it is b^2 times a texel's solid angle, which is what samples
// are made with: it is right at any size.
DRM_FUNCTION float drm_area_across(float b, float gamma, float w) {
#ifdef __cplusplus
    const float a = b * std::tan(gamma / (2 * w));
#else
    float a = b * tan(gamma / (2.0 * w));
#endif
    return 4 * a * a;
}

// Eq. 13: square metres of the surface.
DRM_FUNCTION float drm_area(float across, float cos_alpha) {
#ifdef __cplusplus
    return across / std::max(cos_alpha, kLeastCosAlpha);
#else
    return across / max(cos_alpha, kLeastCosAlpha);
#endif
}

// Eq. 14: steradians, at most cos(theta') however small r is. `r2`: square metres; both 0 is for the caller
// to rule out.
DRM_FUNCTION float drm_solid_angle_14(float cos_theta, float area, float r2) {
    return cos_theta * area / (area + r2);
}
// The same of a disc of that area, seen from above its centre: times cos(theta) its irradiance is exact
// there, at most pi. Eq. 14 has the area where this has the square of the radius.
DRM_FUNCTION float drm_solid_angle_disc(float cos_theta, float area, float r2) {
    return cos_theta * area / (area * 0.31830988618f + r2);
}
// Eq. 15; `diagonal2`: of the scene's box, squared.
DRM_FUNCTION float drm_solid_angle_15(float across, float diagonal2) {
    return across / diagonal2;
}
// Eq. 11, of `samples` in all.
DRM_FUNCTION float drm_solid_angle_11(float samples) {
    return 6.28318530718f / samples;
}

#undef DRM_FUNCTION
#ifdef __cplusplus
}  // namespace lanthorn::gi
#endif
#endif
