#include "engine/assets/gltf_material_layers.h"

#include <algorithm>
#include <cmath>

namespace lanthorn {

namespace {

constexpr float kCoat = 0.04f;                         // F0 of ior 1.5
constexpr float kCoatMean = kCoat + (1 - kCoat) / 21;  // Schlick's, over the hemisphere by cosine

// Of a view at `cosine` to the normal.
float sheen_at(float cosine, float roughness) {
    const float r2 = roughness * roughness;
    const bool smooth = roughness < 0.25f;
    const float a =
        smooth ? -339.2f * r2 + 161.4f * roughness - 25.9f : -8.48f * r2 + 14.3f * roughness - 9.95f;
    const float b = smooth ? 44.0f * r2 - 23.7f * roughness + 3.26f : 1.97f * r2 - 3.27f * roughness + 0.72f;
    const float more = smooth ? 0.0f : 0.1f * (roughness - 0.25f);
    return std::clamp((std::exp(a * cosine + b) + more) / static_cast<float>(kPi), 0.0f, 1.0f);
}

}  // namespace

void add_clearcoat(Material& material, float factor) {
    const float r = (material.ior - 1) / (material.ior + 1);
    const float below = r * r;
    if (below > 0) {
        const float both = below + factor * kCoat * (1 - below);
        material.specular_colour *= both / below;
    }
    const float through = 1 - factor * kCoatMean;
    const float diffuse = through * through;
    const float kept = material.metallic + (1 - material.metallic) * diffuse;
    for (int c = 0; c < 3; ++c) {
        material.base_colour[c] *= kept;
    }
}

float sheen_albedo(float roughness) {
    constexpr int kSteps = 32;
    float sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
        sum += 2 * cosine * sheen_at(cosine, roughness) / kSteps;
    }
    return sum;
}

void add_sheen(Material& material, const vec3& colour, float roughness) {
    const float albedo = sheen_albedo(roughness);
    const float kept = 1 - albedo * std::max({colour.x, colour.y, colour.z});
    for (int c = 0; c < 3; ++c) {
        material.base_colour[c] = std::min(material.base_colour[c] * kept + albedo * colour[c], 1.0f);
    }
}

}  // namespace lanthorn
