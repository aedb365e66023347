// How a photon goes on from what a map shows: by the BSDF of engine/render/brdf.glsl where the surface is glossy, else evenly.
// Behind kept_albedo.glsl.
#ifndef LANTHORN_EMC_SURFACE_BSDF_GLSL
#define LANTHORN_EMC_SURFACE_BSDF_GLSL

#include "engine/render/ggx.glsl"
#include "engine/render/random.glsl"
#include "engine/scene/include/lanthorn/scene/diffuse_reflectance.h"

// Lobes of dielectrics that are wider, perceptual, reflect about evenly.
const float kWidestLobe = 0.7;

struct KeptSurface {
    bool glossy;  // the rest is known; else `albedo` is all there is
    vec3 albedo;  // of even light
    vec3 base;
    float metallic;
    float f0;
    float alpha;  // GGX
};

// Of a texel of a map that keeps albedo (kept_albedo.glsl). What textures say of roughness, metal and specular strength is not kept:
// such surfaces reflect evenly, as do those of too many materials. What light goes through and metal that is a mirror are caustic
// photons' (KHR_materials_transmission, kRoughestMirror).
KeptSurface kept_surface(vec4 texel) {
    KeptSurface s;
    s.glossy = false;
    s.albedo = kept_albedo(texel);
    s.base = vec3(0.0);
    s.metallic = s.f0 = 0.0;
    s.alpha = 1.0;
    uint number = uint(texel.a);
    if (number == 0u) return s;
    MaterialData m = kept_materials[number - 1u];
    const uint kUnknown = (1u << 1) | (1u << 5) | (1u << 6) | (1u << 7) | kMaterialUnlit;
    float factor = base_reflectance(m.metallic, m.transmission, m.roughness, m.reflects.y, m.reflects.z);
    bool lobe = m.metallic > 0.5 ? m.reflects.z > 0.0 : m.roughness < kWidestLobe;
    if ((m.flags & kUnknown) != 0u || m.transmission > 0.0 || !lobe || factor < 1e-3) return s;
    float step = (m.ior - 1.0) / (m.ior + 1.0);
    s.f0 = min(step * step * dot(m.specular_colour.rgb, vec3(0.2126, 0.7152, 0.0722)), 1.0) * m.specular_colour.a;
    if (m.metallic == 0.0 && s.f0 <= 0.0) return s;
    s.glossy = true;
    s.base = min(texel.rgb * m.base_colour.rgb / factor, vec3(1.0));
    s.metallic = m.metallic;
    s.alpha = max(m.roughness * m.roughness, 2e-3);
    return s;
}

struct Scattered {
    vec3 direction;
    vec3 weight;    // of the photon's power
    float density;  // of directions, over 1 / pi: 1 of what scatters evenly, whatever the angle (Yao et al. 2010, sec. 6, leave its cosine out)
};

float schlick(float cosine) {
    float s = 1.0 - clamp(cosine, 0.0, 1.0);
    return s * s * s * s * s;
}

float luminance_of(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// From a surface with unit normal n, light that has come from unit v; u.z chooses between lobe and diffuse part, each as often as it
// reflects, so that power hardly changes by chance. Visible normals are drawn (Heitz 2018), and what is then shadowed weighs less.
// What is shadowed by the surface itself is absorbed, as by the reference.
Scattered scatter_kept(KeptSurface s, vec3 n, vec3 v, vec3 u) {
    Scattered r;
    r.direction = cosine_direction(n, u.xy);
    r.weight = s.albedo;
    r.density = 1.0;
    if (!s.glossy) return r;
    float nv = clamp(dot(n, v), 1e-3, 1.0);
    float rise = min(50.0 * s.f0, 1.0) - s.f0;
    float f = s.f0 + rise * schlick(nv);
    float specular = luminance_of(mix(vec3(f), s.base + (1.0 - s.base) * schlick(nv), s.metallic));
    float diffuse = luminance_of(s.base) * (1.0 - s.metallic) * (1.0 - f);
    float p = specular / max(specular + diffuse, 1e-20);
    if (u.z < p) {
        vec3 h = visible_normal(n, v, s.alpha, u.xy);
        float vh = clamp(dot(v, h), 0.0, 1.0);
        vec3 l = h * (2.0 * dot(v, h)) - v;
        float nl = dot(n, l);
        float a2 = s.alpha * s.alpha;
        float dv = sqrt(a2 + (1.0 - a2) * nv * nv);
        float dl = sqrt(a2 + (1.0 - a2) * nl * nl);
        float shadowing = nl * (nv + dv) / max(nl * dv + nv * dl, 1e-20);  // G2 / G1 (Heitz 2018, eq. 19)
        vec3 reflected = mix(vec3(s.f0 + rise * schlick(vh)), s.base + (1.0 - s.base) * schlick(vh), s.metallic);
        r.direction = nl > 0.0 ? normalize(l) : n;
        r.weight = nl > 0.0 ? reflected * (shadowing / p) : vec3(0.0);
    } else {
        float nl = dot(n, r.direction);
        r.weight = s.base * ((1.0 - s.metallic) * (1.0 - f) * (1.0 - s.f0 - rise * schlick(nl)) / max(1.0 - p, 1e-20));
    }
    r.density = 1.0 - p + p * 3.14159265359 * ggx_density(n, v, r.direction, s.alpha);
    return r;
}

#endif
