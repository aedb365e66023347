// Light at the boundary of two dielectrics: Fresnel's equations, Snell's law, and rough boundaries by Walter
// et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
#pragma once

#include "gi_module/reference/bsdf.h"

namespace lanthorn::reference {

// A direction and its part in Fresnel's equations. `eta`: index of refraction beyond the boundary over that
// before it, > 0.
struct Incidence {
    float cosine = 1;       // before, 0 to 1
    float beyond = 1;       // cosine of the refracted direction; 0 where reflection is total
    float reflectance = 0;  // of unpolarised light at a smooth boundary, 0 to 1; 1 where it is total

    Incidence(float cosine_before, float eta) : cosine(cosine_before) {
        // 1 - sin^2 / eta^2, written so that eta = 1 gives cosine^2 exactly.
        const float squared = (eta * eta - 1 + cosine * cosine) / (eta * eta);
        if (!(squared > 0)) {
            beyond = 0;
            reflectance = 1;
            return;
        }
        beyond = std::sqrt(squared);
        const float parallel = (eta * cosine - beyond) / (eta * cosine + beyond);
        const float square = (cosine - eta * beyond) / (cosine + eta * beyond);
        reflectance = eta == 1 ? 0 : 0.5f * (parallel * parallel + square * square);
    }
};

// Unit `v`, which points away from the boundary, mirrored at unit `n` or bent through it (Snell 1621).
inline vec3 mirrored(const vec3& v, const vec3& n) {
    return n * (2 * glm::dot(n, v)) - v;
}
inline vec3 refracted(const vec3& v, const vec3& n, const Incidence& at, float eta) {
    return n * (at.cosine / eta - at.beyond) - v * (1 / eta);
}

struct BoundarySample {
    vec3 direction{0};  // unit; that light comes from
    bool through = false;
    float weight =
        0;  // BSDF times cosine over density, tint and change of radiance by n^2 left out; 0: masked
};

// One of the ways of light that leaves a boundary towards unit `v`. `n`: shading, `geometric`: the triangle's
// own normal, unit and on the side of `v`. Perceptual `roughness`; a smooth boundary (is_smooth) has weight 1
// always. `choice` and `u` in [0, 1).
inline BoundarySample sample_boundary(const vec3& v, vec3 n, const vec3& geometric, float eta,
                                      float roughness, float choice, const vec2& u) {
    if (!(glm::dot(n, v) > 0)) {
        n = geometric;
    }
    const bool smooth = is_smooth(roughness) || eta == 1;
    const float alpha = std::max(roughness * roughness, kSmallestAlpha);
    const Basis basis(n);
    const vec3 h = smooth ? n : basis.to_world(visible_normal(basis.to_local(v), alpha, u));
    const auto about = [&](const vec3& facet) {
        const Incidence at(glm::clamp(glm::dot(v, facet), 0.0f, 1.0f), eta);
        BoundarySample sample;
        sample.through = choice >= at.reflectance;
        sample.direction = unit(sample.through ? refracted(v, facet, at, eta) : mirrored(v, facet));
        const bool right_side = (glm::dot(geometric, sample.direction) < 0) == sample.through;
        sample.weight = right_side ? 1.0f : 0.0f;
        return sample;
    };
    BoundarySample sample = about(h);
    if (smooth) {
        // A shading normal may send light to the wrong side of the triangle.
        return sample.weight > 0 ? sample : about(geometric);
    }
    const float nl = sample.through ? -glm::dot(n, sample.direction) : glm::dot(n, sample.direction);
    // With visible normals (Heitz 2018) all that is left of Walter et al.'s eqs. 20 and 21 is the masking of
    // the other direction, their eq. 34.
    const float a2 = alpha * alpha;
    sample.weight *= nl > 0 ? 2 * nl / (nl + std::sqrt(a2 + (1 - a2) * nl * nl)) : 0.0f;
    return sample;
}

}  // namespace lanthorn::reference
