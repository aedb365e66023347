#include "engine/scene/kept_emissive_pieces.h"

#include <algorithm>

namespace lanthorn {

KeptEmissivePieces::Shown KeptEmissivePieces::shown(const SceneAssets& assets, const TextureRef& reference) {
    if (!reference.present()) {
        return {};
    }
    return {reference, assets.textures.version(reference.texture).any,
            assets.images.version(assets.textures[reference.texture].image).any};
}

KeptEmissivePieces::Key KeptEmissivePieces::key_of(const SceneAssets& assets, std::uint32_t mesh) {
    const Material& material = assets.materials[assets.meshes[mesh].material];
    Key key;
    key.mesh = assets.meshes.version(mesh).any;
    key.alpha_mode = material.alpha_mode;
    key.emission = shown(assets, material.emissive_texture);
    if (material.alpha_mode != AlphaMode::opaque) {
        key.base = shown(assets, material.base_colour_texture);
    }
    if (material.alpha_mode == AlphaMode::mask) {
        key.cutoff = material.alpha_cutoff;
        key.alpha = material.base_colour.a;
    }
    return key;
}

std::shared_ptr<const EmissivePieces> KeptEmissivePieces::of(const SceneAssets& assets, std::uint32_t mesh) {
    kept_.resize(std::max(kept_.size(), assets.meshes.size()));
    Kept& kept = kept_[mesh];
    const Material& material = assets.materials[assets.meshes[mesh].material];
    if (!gives_light(material) || !glows_in_pieces(material)) {
        kept = {};
        return nullptr;
    }
    const Key now = key_of(assets, mesh);
    if (!kept.pieces || kept.key != now) {
        kept = {now, std::make_shared<const EmissivePieces>(
                         emissive_pieces(assets, assets.meshes[mesh], material))};
    }
    return kept.pieces;
}

}  // namespace lanthorn
