// What surfaces reflect of light that comes evenly from all sides, as a single albedo: what light keeps that
// is bounced on, by every technique and by the reference's diffuse transport. Both parts of the BRDF
// (engine/render/brdf.glsl) are in it, each in the mean over all directions. Included by C++ and by GLSL:
// keep to both.
#ifndef LANTHORN_DIFFUSE_REFLECTANCE_H
#define LANTHORN_DIFFUSE_REFLECTANCE_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"
#include "lanthorn/scene/material.h"

#define LANTHORN_SHARED inline
namespace lanthorn {
#else
#define LANTHORN_SHARED
#endif

// What a GGX lobe (Smith's height-correlated masking) reflects of even light where Fresnel takes nothing, x
// of it towards where Schlick's (1 - vh)^5 is 0, y towards where it is 1: the lobe reflects f0 x + f90 y.
// Polynomials in perceptual roughness 0..1, off by at most 0.002.
LANTHORN_SHARED vec2 mean_brdf_share(float roughness) {
    float r = roughness;
    return vec2(0.9524f + r * (-0.0402f + r * (0.6802f + r * (-2.6525f + r * 1.4681f))),
                0.0471f + r * (0.0409f + r * (-0.4148f + r * (0.5518f + r * -0.2225f))));
}

// How much of its base colour a surface reflects. `transmittance`: MaterialReflectance's; `evenly`: 1, or 0
// for a metal whose light is followed as that of a mirror.
LANTHORN_SHARED float base_reflectance(float metallic, float transmission, float roughness,
                                       float transmittance, float evenly) {
    vec2 share = mean_brdf_share(roughness);
    return (1.0f - metallic) * (1.0f - transmission) * transmittance +
           metallic * evenly * (share.x + share.y);
}

#undef LANTHORN_SHARED
#ifdef __cplusplus

// The roughest metal that throws patterns of light (caustics) instead of reflecting evenly. Perceptual, 0..1.
inline constexpr float kRoughestMirror = 0.4f;

inline bool is_mirror(const Material& m) {
    return m.metallic > 0.5f && m.roughness < kRoughestMirror;
}

// What of a material's reflectance its base colour does not tint, and what does not change over a surface.
// Textures of KHR_materials_specular do not count, and where one says how metallic the surface is, or how
// much of the light goes through it, its boundary counts whole.
struct MaterialReflectance {
    float boundary = 0;       // of even light, what a dielectric's boundary reflects
    float transmittance = 1;  // what passes it on the way in and on the way out, in the mean
    float evenly = 1;         // 0: a mirror

    // Once a material: O(1).
    static MaterialReflectance of(const Material& m);
};

}  // namespace lanthorn
#endif
#endif
