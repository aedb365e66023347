// How light scatters at a surface: glTF's metallic-roughness model as engine/render/brdf.glsl has it, and
// thin transmission (KHR_materials_transmission), with the densities to draw directions from.
#pragma once

#include <algorithm>

#include "gi_module/reference/material_table.h"

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

class Bsdf {
  public:
    // `n`: shading, `geometric`: the triangle's own normal, both unit and on the side of unit `v`, which
    // points to where the light goes. `straight`: what is transmitted goes straight on (straight_through())
    // and is no part of this.
    Bsdf(const SurfaceMaterial& m, const vec3& n, const vec3& geometric, const vec3& v, bool straight);

    // BSDF times cosine for light from unit `l`; times alpha.
    vec3 evaluate(const vec3& l) const;
    // Probability per solid angle with which sample() returns `l`.
    float density(const vec3& l) const;
    // A direction the light may come from; `choice` and `u` in [0, 1). Where density() of it is 0, there is
    // none.
    vec3 sample(float choice, const vec2& u) const;
    // The share of light that goes straight on: past a blended surface, through a smooth thin one.
    vec3 straight_through() const { return straight_; }

  private:
    vec3 reflected(const vec3& l) const;
    float specular_density(const vec3& l) const;

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
