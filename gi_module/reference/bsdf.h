// How light scatters at a surface: glTF's metallic-roughness model as engine/render/brdf.glsl has it, and
// thin transmission (KHR_materials_transmission), with the densities to draw directions from.
#pragma once

#include <algorithm>
#include <cmath>

#include "gi_module/reference/material_table.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

// GGX's alpha is kept above this, as in brdf.glsl: a mirror is a very narrow lobe.
inline constexpr float kSmallestAlpha = 2e-3f;

// Whether what is transmitted at this perceptual roughness goes straight on.
inline bool is_smooth(float roughness) {
    return roughness * roughness <= kSmallestAlpha;
}

// Diffuse reflection alone, about `normal`.
struct Lambert {
    vec3 albedo;
    vec3 normal;  // unit

    vec3 evaluate(const vec3& l) const { return albedo * (std::max(glm::dot(normal, l), 0.0f) * (1 / kPi)); }
    float density(const vec3& l) const { return std::max(glm::dot(normal, l), 0.0f) * (1 / kPi); }
};

inline float fifth_power(float x) {
    const float x2 = x * x;
    return x2 * x2 * x;
}

// Schlick 1994, as in brdf.glsl: a dielectric without specular reflection has none at grazing angles either.
inline float dielectric_fresnel(float f0, float cosine) {
    return f0 + (std::min(50 * f0, 1.0f) - f0) * fifth_power(1 - cosine);
}

// GGX (Walter et al. 2007, eq. 33).
inline float ggx(float nh, float a) {
    const float a2 = a * a;
    const float d = (nh * a2 - nh) * nh + 1;
    return a2 / (kPi * d * d);
}

// Height-correlated Smith masking and shadowing over 4 nl nv (Heitz 2014, eq. 99).
inline float visibility(float nl, float nv, float a) {
    const float a2 = a * a;
    return 0.5f / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
}

// A normal of the GGX surface as seen from `v` (local frame, v.z > 0): Heitz 2018, "Sampling the GGX
// Distribution of Visible Normals", listing 1.
[[gnu::always_inline]] inline vec3 visible_normal(const vec3& v, float a, const vec2& u) {
    const vec3 vh = unit(vec3(a * v.x, a * v.y, v.z));
    const float across = vh.x * vh.x + vh.y * vh.y;
    const float inverse = 1 / std::sqrt(across);
    const vec3 t1 = select(across > 0, vec3(-vh.y * inverse, vh.x * inverse, 0), vec3(1, 0, 0));
    const vec3 t2 = glm::cross(vh, t1);
    const vec2 p = on_circle(u.y) * std::sqrt(u.x);
    const float s = 0.5f * (1 + vh.z);
    const float p2 = (1 - s) * std::sqrt(std::max(1 - p.x * p.x, 0.0f)) + s * p.y;
    const vec3 nh = t1 * p.x + t2 * p2 + vh * std::sqrt(std::max(1 - p.x * p.x - p2 * p2, 0.0f));
    return unit(vec3(a * nh.x, a * nh.y, std::max(nh.z, 1e-6f)));
}

// Without a jump and inline: loops over lanes become vector code of it.
class Bsdf {
  public:
    // `n`: shading, `geometric`: the triangle's own normal, both unit and on the side of unit `v`, which
    // points to where the light goes. `straight`: what is transmitted goes straight on (straight_through())
    // and is no part of this.
    [[gnu::always_inline]] Bsdf(const SurfaceMaterial& m, const vec3& n, const vec3& geometric, const vec3& v,
                                bool straight)
        : n_(n), geometric_(geometric), v_(v), metallic_(m.metallic), f0_(m.f0), coverage_(m.alpha) {
        alpha_ = std::max(m.roughness * m.roughness, kSmallestAlpha);
        base_ = m.base_colour * glm::mix(1 - m.transmission, 1.0f, m.metallic);
        const float below = glm::dot(n, v);
        v_sampling_ = select(below < 1e-3f, unit(v + n * (1e-3f - below)), v);

        const float nv = glm::clamp(below, 0.0f, 1.0f);
        const float fresnel = dielectric_fresnel(m.f0, nv);
        const vec3 passing = m.base_colour * (m.transmission * (1 - m.metallic));
        straight_ = vec3(1 - m.alpha) + select(straight, passing * (m.alpha * (1 - fresnel)), vec3(0));
        transmitted_ = select(straight, vec3(0), passing);
        const vec3 metal = m.base_colour + (1.0f - m.base_colour) * fifth_power(1 - nv);
        const float specular = luminance(glm::mix(vec3(fresnel), metal, m.metallic));
        const float diffuse = luminance(base_) * (1 - m.metallic) * (1 - fresnel);
        const float transmitted = luminance(transmitted_) * (1 - fresnel);
        const float sum = std::max(specular + diffuse + transmitted, 1e-20f);
        // Where there is a lobe at all it is drawn from often enough for its grazing angles.
        p_specular_ = specular > 0 ? std::max(specular / sum, 0.1f) : 0.0f;
        p_transmitted_ = (1 - p_specular_) * transmitted / std::max(diffuse + transmitted, 1e-20f);
    }

    // BSDF times cosine for light from unit `l`; times alpha.
    [[gnu::always_inline]] vec3 evaluate(const vec3& l) const {
        const float nl = glm::dot(n_, l);
        const bool same_side = glm::dot(geometric_, l) > 0;
        // Through a thin wall: the lobe of reflection, mirrored to the other side.
        const vec3 h = unit(v_ + select(same_side, l, l - n_ * (2 * nl)));
        const float nv = std::max(glm::dot(n_, v_), 1e-4f);
        const float nh = glm::clamp(glm::dot(n_, h), 0.0f, 1.0f);
        const float vh = glm::clamp(glm::dot(v_, h), 0.0f, 1.0f);
        const float cosine = std::max(same_side ? nl : -nl, 0.0f);
        const float lobe = ggx(nh, alpha_) * visibility(std::max(cosine, 1e-4f), nv, alpha_);
        const float dielectric = dielectric_fresnel(f0_, vh);
        const vec3 metal = base_ + (1.0f - base_) * fifth_power(1 - vh);
        const float leaves = (1 - dielectric_fresnel(f0_, std::min(cosine, 1.0f))) *
                             (1 - dielectric_fresnel(f0_, std::min(nv, 1.0f)));
        const vec3 diffuse = base_ * ((1 - metallic_) * leaves * (1 / kPi));
        const vec3 reflected = diffuse + glm::mix(vec3(dielectric), metal, metallic_) * lobe;
        return select(same_side, reflected, transmitted_ * ((1 - dielectric) * lobe)) * (coverage_ * cosine);
    }
    // Probability per solid angle with which sample() returns `l`.
    [[gnu::always_inline]] float density(const vec3& l) const {
        const float nl = glm::dot(n_, l);
        const bool same_side = glm::dot(geometric_, l) > 0;
        const float specular = specular_density(select(same_side, l, l - n_ * (2 * nl)));
        const float p_diffuse = 1 - p_specular_ - p_transmitted_;
        const float reflected = p_diffuse * nl * (1 / kPi) + p_specular_ * specular;
        const float cosine = same_side ? nl : -nl;
        return cosine > 0 ? (same_side ? reflected : p_transmitted_ * specular) : 0.0f;
    }
    // A direction the light may come from; `choice` and `u` in [0, 1). Where density() of it is 0, there is
    // none.
    [[gnu::always_inline]] vec3 sample(float choice, const vec2& u) const {
        const vec3 n = n_;
        const Basis basis(n);
        const vec3 h = basis.to_world(visible_normal(basis.to_local(v_sampling_), alpha_, u));
        const vec3 l = h * (2 * glm::dot(v_sampling_, h)) - v_sampling_;
        const float nl = glm::dot(n_, l);
        const vec3 reflected = select(choice < p_specular_, l, l - n_ * (2 * nl));
        // Below the horizon it is masked by the surface itself.
        const vec3 lobe = select(nl > 0, reflected, vec3(0));
        return select(choice >= p_specular_ + p_transmitted_, cosine_direction(n, u), lobe);
    }
    // The share of light that goes straight on: past a blended surface, through a smooth thin one.
    vec3 straight_through() const { return straight_; }

  private:
    [[gnu::always_inline]] float specular_density(const vec3& l) const {
        const vec3 h = unit(v_sampling_ + l);
        const float nv = glm::dot(n_, v_sampling_), nh = glm::dot(n_, h);
        // G1 D / (4 nv) (Heitz 2018, eq. 17), with G1 = 2 nv / (nv + sqrt(a^2 + (1 - a^2) nv^2)).
        const float a2 = alpha_ * alpha_;
        const float density = ggx(nh, alpha_) / (2 * (nv + std::sqrt(a2 + (1 - a2) * nv * nv)));
        return nh > 0 && nv > 0 ? density : 0.0f;
    }

    vec3 base_;         // less what is transmitted
    vec3 transmitted_;  // rough transmission: tint times share, without Fresnel
    vec3 straight_;
    vec3 n_, geometric_, v_;
    vec3 v_sampling_;  // v, lifted above the shading normal's horizon
    float alpha_;      // GGX
    float metallic_, f0_, coverage_;
    float p_specular_, p_transmitted_;  // the rest is diffuse
};

}  // namespace lanthorn::reference
