// What a sample of a direct radiance map covers, and what a surface gets of it: Frisvad et al. 2005, sec. 4.
//
// alpha: between the light's way and the normal where it arrives; theta': between that normal and the way on to the point that
// receives; theta: between that way and the receiver's normal; r: metres between the two.
#ifndef LANTHORN_DRM_SOLID_ANGLE_GLSL
#define LANTHORN_DRM_SOLID_ANGLE_GLSL

// Least cos(alpha) of eq. 13, which divides by it: light that grazes a surface lies on twenty times its own width of it at most.
const float kLeastCosAlpha = 0.05;

// Eq. 13: square metres of the surface.
float drm_area(float across, float cos_alpha) {
    return across / max(cos_alpha, kLeastCosAlpha);
}

// Eq. 14 times cos(theta), over the area: with `here` = r cos(theta) and `there` = r cos(theta'), the irradiance by an area whose
// radiance times that area is 1. At most 1 / area however small r2 = r^2 is; both 0 is for the caller to rule out. With the
// area over pi in place of the area it is a disc's, exact on its axis: there eq. 14 has the area where a disc has the square of its radius.
float drm_share_by_area(float here, float there, float area, float r2) {
    return here * there / (r2 * (area + r2));
}

// Eq. 13's area over r^2, the usual projection that eq. 14 replaces: to infinity as the distance goes to 0.
float drm_share_by_projection(float here, float there, float r2) {
    return here / r2 * (there / r2);
}

// cos(theta), which eqs. 11 and 15 leave to the receiver.
float drm_share_by_angle(float here, float r2) {
    return here * inversesqrt(r2);
}

// Eq. 11, of `samples` in all.
float drm_solid_angle_11(float samples) {
    return 6.28318530718 / samples;
}

// Eq. 15, per channel of what is sent times A'; `diagonal2`: of the scene's box, squared.
vec3 drm_sent_15(vec3 sent_across, float diagonal2) {
    return sent_across / diagonal2;
}

#endif
