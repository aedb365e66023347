#include "engine/scene/asset_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/finite.h"

namespace lanthorn {

namespace {

std::string number(std::size_t n) {
    return std::to_string(n);
}

bool within_unit(float value) {
    return value >= 0 && value <= 1;
}

}  // namespace

std::string problem_of(const Mesh& mesh, const SceneAssets& among) {
    const std::size_t count = mesh.vertices.size();
    if (!among.materials.has(mesh.material)) {
        return "material " + number(mesh.material) + " is not in the store, expected a slot of its materials";
    }
    if (mesh.indices.size() % 3 != 0) {
        return number(mesh.indices.size()) + " indices, expected a multiple of 3";
    }
    for (const std::uint32_t index : mesh.indices) {
        if (index >= count) {
            return "index " + number(index) + ", expected less than its " + number(count) + " vertices";
        }
    }
    if (!mesh.skin.empty() && mesh.skin.size() != count) {
        return number(mesh.skin.size()) + " skin influences, expected none or one for each of its " +
               number(count) + " vertices";
    }
    for (const MorphTarget& target : mesh.morphs) {
        const std::size_t moved = target.vertices.size();
        const bool fits = target.positions.size() == moved &&
                          (target.normals.empty() || target.normals.size() == moved) &&
                          (target.tangents.empty() || target.tangents.size() == moved);
        if (!fits || std::ranges::any_of(target.vertices, [&](std::uint32_t v) { return v >= count; })) {
            return "a morph target's lists differ in length or name vertices past its " + number(count);
        }
    }
    return {};
}

std::string problem_of(const Material& m, const SceneAssets& among) {
    if (!is_finite(m.base_colour) || !is_finite(m.emissive) || !is_finite(m.specular_colour) ||
        !std::isfinite(m.normal_scale) || !std::isfinite(m.occlusion_strength) ||
        !std::isfinite(m.alpha_cutoff) || !std::isfinite(m.specular)) {
        return "a colour or factor is not a finite number";
    }
    if (std::min({m.emissive.x, m.emissive.y, m.emissive.z}) < 0 ||
        std::min({m.base_colour.r, m.base_colour.g, m.base_colour.b, m.base_colour.a}) < 0) {
        return "a colour is negative, expected 0 or more";
    }
    if (!within_unit(m.metallic) || !within_unit(m.roughness) || !within_unit(m.transmission)) {
        return "metallic, roughness or transmission is out of range, expected 0..1";
    }
    if (!(m.thickness >= 0) || !std::isfinite(m.thickness) || !(m.attenuation_distance >= 0) ||
        !std::isfinite(m.attenuation_distance)) {
        return "thickness or attenuation distance is negative or not a finite number";
    }
    if (!within_unit(m.attenuation_colour.x) || !within_unit(m.attenuation_colour.y) ||
        !within_unit(m.attenuation_colour.z)) {
        return "the attenuation colour is out of range, expected 0..1";
    }
    if (!(m.ior >= 1)) {
        return "the index of refraction is below 1";
    }
    for (const TextureRef* reference : m.textures()) {
        if (reference->present() && !among.textures.has(reference->texture)) {
            return "texture " + number(reference->texture) +
                   " is not in the store, expected a slot of its textures";
        }
        if (reference->uv_set > 1) {
            return "UV set " + number(reference->uv_set) + ", expected 0 or 1";
        }
    }
    return {};
}

std::string problem_of(const Texture& texture, const SceneAssets& among) {
    return among.images.has(texture.image)
               ? std::string()
               : "image " + number(texture.image) + " is not in the store, expected a slot of its images";
}

std::string problem_of(const Image& image, const SceneAssets&) {
    const std::size_t expected = std::size_t{image.width} * image.height * 4;
    return image.rgba.size() == expected || image.rgba.empty()
               ? std::string()
               : number(image.rgba.size()) + " bytes of pixels, expected " + number(expected) + " for " +
                     number(image.width) + " x " + number(image.height);
}

}  // namespace lanthorn
