#include "lanthorn/render/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lanthorn::render {

namespace {

constexpr int kSide = 32;
constexpr std::uint32_t kDirections = 256;
constexpr float kPi = 3.14159265f;
constexpr float kSmallestAlpha = 2e-3f;  // brdf.glsl

float radical_inverse(std::uint32_t i) {
    float result = 0;
    for (float digit = 0.5f; i > 0; i >>= 1, digit *= 0.5f) {
        result += static_cast<float>(i & 1u) * digit;
    }
    return result;
}

// A normal of the GGX surface as seen from v (Heitz 2018, listing 1), in the frame of the surface.
vec3 visible_normal(const vec3& v, float a, const vec2& u) {
    const vec3 vh = glm::normalize(vec3(a * v.x, a * v.y, v.z));
    const float across = vh.x * vh.x + vh.y * vh.y;
    const vec3 t1 = across > 0 ? vec3(-vh.y, vh.x, 0) / std::sqrt(across) : vec3(1, 0, 0);
    const vec3 t2 = glm::cross(vh, t1);
    const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
    const float p1 = r * std::cos(phi);
    const float s = 0.5f * (1 + vh.z);
    const float p2 = (1 - s) * std::sqrt(std::max(1 - p1 * p1, 0.0f)) + s * r * std::sin(phi);
    const vec3 n = p1 * t1 + p2 * t2 + std::sqrt(std::max(1 - p1 * p1 - p2 * p2, 0.0f)) * vh;
    return glm::normalize(vec3(a * n.x, a * n.y, std::max(n.z, 1e-6f)));
}

float fifth_power(float x) {
    return x * x * x * x * x;
}

// Smith's G1 (Heitz 2014).
float masking(float cosine, float a) {
    return 2 * cosine / (cosine + std::sqrt(a * a + (1 - a * a) * cosine * cosine));
}

// Height-correlated masking and shadowing over the masking alone.
float shadowing(float nv, float nl, float a) {
    const float a2 = a * a;
    const float both = nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2);
    return 2 * nl * nv / both / masking(nv, a);
}

}  // namespace

vec2 brdf_share(float nv, float roughness) {
    nv = std::clamp(nv, 1e-3f, 1.0f);
    const float a = std::max(roughness * roughness, kSmallestAlpha);
    const vec3 v(std::sqrt(1 - nv * nv), 0, nv);
    vec2 sum(0);
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const vec2 u((static_cast<float>(i) + 0.5f) / static_cast<float>(kDirections), radical_inverse(i));
        const vec3 h = visible_normal(v, a, u);
        const float vh = std::max(glm::dot(v, h), 0.0f);
        const vec3 l = 2 * vh * h - v;
        if (l.z > 0) {
            const float weight = shadowing(nv, l.z, a);
            sum.x += weight * (1 - fifth_power(1 - vh));
            sum.y += weight * fifth_power(1 - vh);
        }
    }
    return sum / static_cast<float>(kDirections);
}

BrdfTable::BrdfTable() : texture_(gpu::Texture::make_2d(GL_RG32F, ivec2(kSide))) {
    static const std::vector<vec2> table = [] {
        std::vector<vec2> cells;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                constexpr float kLast = kSide - 1;
                cells.push_back(brdf_share(static_cast<float>(x) / kLast, static_cast<float>(y) / kLast));
            }
        }
        return cells;
    }();
    texture_.set_filter(GL_LINEAR, GL_LINEAR);
    glTextureSubImage2D(texture_.id(), 0, 0, 0, kSide, kSide, GL_RG, GL_FLOAT, table.data());
}

}  // namespace lanthorn::render
