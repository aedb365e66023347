#include "engine/assets/solid_blends.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace lanthorn {

namespace {

bool is_solid(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) {
            return false;
        }
    }
    return true;
}

}  // namespace

void make_solid_blends_opaque(SceneData& scene, const std::vector<bool>& textured) {
    std::vector<bool> solid;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        const bool lost = i < textured.size() && textured[i] && !m.base_colour_texture.present();
        solid.push_back(m.alpha_mode == AlphaMode::blend && m.base_colour.a >= 1 && !lost);
    }
    for (const AnimationClip& clip : scene.animations) {
        for (const PropertyChannel& channel : clip.properties) {
            if (channel.property == AnimatedProperty::base_colour) {
                solid[channel.object] = false;
            }
        }
    }
    for (const Mesh& mesh : scene.meshes) {
        const auto is_clear = [](const Vertex& vertex) { return vertex.colour.a < 1; };
        if (solid[mesh.material] && std::ranges::any_of(mesh.vertices, is_clear)) {
            solid[mesh.material] = false;
        }
    }
    std::vector<std::optional<bool>> known(scene.images.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& m = scene.materials[i];
        if (solid[i] && m.base_colour_texture.present()) {
            const std::uint32_t image = scene.textures[m.base_colour_texture.texture].image;
            known[image] = known[image] ? known[image] : is_solid(scene.images[image]);
            solid[i] = *known[image];
        }
        if (solid[i]) {
            m.alpha_mode = AlphaMode::opaque;
            scene.warnings.push_back(fmt::format(
                "/materials/{}/alphaMode: BLEND, though its alpha is 1 everywhere; OPAQUE is used", i));
        }
    }
}

}  // namespace lanthorn
