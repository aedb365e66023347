#include "gi_module/reference/bsdf.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

float fifth_power(float x) {
    const float x2 = x * x;
    return x2 * x2 * x;
}

// Schlick 1994, as in brdf.glsl: a dielectric without specular reflection has none at grazing angles either.
float dielectric_fresnel(float f0, float cosine) {
    return f0 + (std::min(50 * f0, 1.0f) - f0) * fifth_power(1 - cosine);
}

// GGX (Walter et al. 2007, eq. 33).
float ggx(float nh, float a) {
    const float a2 = a * a;
    const float d = (nh * a2 - nh) * nh + 1;
    return a2 / (kPi * d * d);
}

// Height-correlated Smith masking and shadowing over 4 nl nv (Heitz 2014, eq. 99).
float visibility(float nl, float nv, float a) {
    const float a2 = a * a;
    return 0.5f / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
}

// A normal of the GGX surface as seen from `v` (local frame, v.z > 0): Heitz 2018, "Sampling the GGX
// Distribution of Visible Normals", listing 1.
vec3 visible_normal(const vec3& v, float a, const vec2& u) {
    const vec3 vh = glm::normalize(vec3(a * v.x, a * v.y, v.z));
    const float across = vh.x * vh.x + vh.y * vh.y;
    const vec3 t1 = across > 0 ? vec3(-vh.y, vh.x, 0) / std::sqrt(across) : vec3(1, 0, 0);
    const vec3 t2 = glm::cross(vh, t1);
    const float r = std::sqrt(u.x);
    const float phi = 2 * kPi * u.y;
    const float p1 = r * std::cos(phi);
    const float s = 0.5f * (1 + vh.z);
    const float p2 = (1 - s) * std::sqrt(std::max(1 - p1 * p1, 0.0f)) + s * r * std::sin(phi);
    const vec3 nh = t1 * p1 + t2 * p2 + vh * std::sqrt(std::max(1 - p1 * p1 - p2 * p2, 0.0f));
    return glm::normalize(vec3(a * nh.x, a * nh.y, std::max(nh.z, 1e-6f)));
}

}  // namespace

Bsdf::Bsdf(const SurfaceMaterial& m, const vec3& n, const vec3& geometric, const vec3& v, bool straight)
    : n_(n), geometric_(geometric), v_(v), metallic_(m.metallic), f0_(m.f0), coverage_(m.alpha) {
    alpha_ = std::max(m.roughness * m.roughness, kSmallestAlpha);
    base_ = m.base_colour * glm::mix(1 - m.transmission, 1.0f, m.metallic);
    const float below = glm::dot(n, v);
    v_sampling_ = below < 1e-3f ? glm::normalize(v + n * (1e-3f - below)) : v;

    const float nv = glm::clamp(below, 0.0f, 1.0f);
    const float fresnel = dielectric_fresnel(m.f0, nv);
    const vec3 passing = m.base_colour * (m.transmission * (1 - m.metallic));
    straight_ = vec3(1 - m.alpha);
    transmitted_ = vec3(0);
    if (straight) {
        straight_ += passing * (m.alpha * (1 - fresnel));
    } else {
        transmitted_ = passing;
    }
    const vec3 metal = m.base_colour + (1.0f - m.base_colour) * fifth_power(1 - nv);
    const float specular = luminance(glm::mix(vec3(fresnel), metal, m.metallic));
    const float diffuse = luminance(base_) * (1 - m.metallic) * (1 - fresnel);
    const float transmitted = luminance(transmitted_) * (1 - fresnel);
    const float sum = std::max(specular + diffuse + transmitted, 1e-20f);
    // Where there is a lobe at all it is drawn from often enough for its grazing angles.
    p_specular_ = specular > 0 ? std::max(specular / sum, 0.1f) : 0.0f;
    p_transmitted_ = (1 - p_specular_) * transmitted / std::max(diffuse + transmitted, 1e-20f);
}

vec3 Bsdf::reflected(const vec3& l) const {
    const vec3 h = glm::normalize(v_ + l);
    const float nl = std::max(glm::dot(n_, l), 1e-4f);
    const float nv = std::max(glm::dot(n_, v_), 1e-4f);
    const float nh = glm::clamp(glm::dot(n_, h), 0.0f, 1.0f);
    const float vh = glm::clamp(glm::dot(v_, h), 0.0f, 1.0f);
    const float dielectric = dielectric_fresnel(f0_, vh);
    const vec3 metal = base_ + (1.0f - base_) * fifth_power(1 - vh);
    const vec3 diffuse = base_ * ((1 - metallic_) * (1 - dielectric) * (1 / kPi));
    return diffuse +
           glm::mix(vec3(dielectric), metal, metallic_) * (ggx(nh, alpha_) * visibility(nl, nv, alpha_));
}

vec3 Bsdf::evaluate(const vec3& l) const {
    if (glm::dot(geometric_, l) > 0) {
        return reflected(l) * (coverage_ * std::max(glm::dot(n_, l), 0.0f));
    }
    const float nl = -glm::dot(n_, l);
    if (transmitted_ == vec3(0) || nl <= 0) {
        return vec3(0);
    }
    // A thin wall: the lobe of reflection, mirrored to the other side.
    const vec3 mirrored = l + n_ * (2 * nl);
    const vec3 h = glm::normalize(v_ + mirrored);
    const float nv = std::max(glm::dot(n_, v_), 1e-4f);
    const float lobe =
        ggx(glm::clamp(glm::dot(n_, h), 0.0f, 1.0f), alpha_) * visibility(std::max(nl, 1e-4f), nv, alpha_);
    const float fresnel = dielectric_fresnel(f0_, glm::clamp(glm::dot(v_, h), 0.0f, 1.0f));
    return transmitted_ * (coverage_ * (1 - fresnel) * lobe * nl);
}

float Bsdf::specular_density(const vec3& l) const {
    const vec3 h = glm::normalize(v_sampling_ + l);
    const float nv = glm::dot(n_, v_sampling_), nh = glm::dot(n_, h);
    if (!(nh > 0) || !(nv > 0)) {
        return 0;
    }
    // G1 D / (4 nv) (Heitz 2018, eq. 17), with G1 = 2 nv / (nv + sqrt(a^2 + (1 - a^2) nv^2)).
    const float a2 = alpha_ * alpha_;
    return ggx(nh, alpha_) / (2 * (nv + std::sqrt(a2 + (1 - a2) * nv * nv)));
}

float Bsdf::density(const vec3& l) const {
    const float nl = glm::dot(n_, l);
    if (glm::dot(geometric_, l) > 0) {
        if (nl <= 0) {
            return 0;
        }
        const float p_diffuse = 1 - p_specular_ - p_transmitted_;
        return p_diffuse * nl * (1 / kPi) + (p_specular_ > 0 ? p_specular_ * specular_density(l) : 0.0f);
    }
    return p_transmitted_ > 0 && nl < 0 ? p_transmitted_ * specular_density(l - n_ * (2 * nl)) : 0.0f;
}

vec3 Bsdf::sample(float choice, const vec2& u) const {
    if (choice >= p_specular_ + p_transmitted_) {
        return cosine_direction(n_, u);
    }
    const Basis basis(n_);
    const vec3 h = basis.to_world(visible_normal(basis.to_local(v_sampling_), alpha_, u));
    const vec3 l = h * (2 * glm::dot(v_sampling_, h)) - v_sampling_;
    const float nl = glm::dot(n_, l);
    if (nl <= 0) {
        return vec3(0);  // masked by the surface itself
    }
    return choice < p_specular_ ? l : l - n_ * (2 * nl);
}

}  // namespace lanthorn::reference
