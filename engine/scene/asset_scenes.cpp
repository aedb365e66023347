#include "engine/scene/asset_scenes.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace lanthorn {

namespace {

std::vector<float> start_weights(const NodeData& node, const std::vector<Mesh>& meshes) {
    std::vector<float> weights = node.morph_weights;
    std::size_t targets = 0;
    for (const std::uint32_t index : node.meshes) {
        const Mesh& mesh = meshes.at(index);
        targets = std::max(targets, mesh.morphs.size());
        if (weights.empty()) {
            weights = mesh.morph_weights;
        }
    }
    weights.resize(targets, 0.0f);
    return weights;
}

}  // namespace

SceneHandle find_same_scene(const AssetState& state, const SceneData& scene, const SceneDigest& digest) {
    const AssetTable<SceneAsset>& scenes = state.scenes;
    for (std::size_t slot = 0; slot < scenes.size(); ++slot) {
        if (scenes.has(slot) && scenes[slot].digest == digest && scenes[slot].source == scene.source) {
            return scenes.handle(slot);
        }
    }
    return {};
}

// Indices become slots.
SceneHandle join_scene(AssetState& state, SceneData&& scene, const SceneDigest& digest) {
    SceneAsset asset;
    asset.source = std::move(scene.source);
    asset.digest = digest;
    asset.file = std::move(scene.file);
    for (const NodeData& node : scene.nodes) {
        asset.weights.push_back(start_weights(node, scene.meshes));
    }
    for (Image& image : scene.images) {
        asset.images.push_back(state.add(std::move(image)));
    }
    for (Texture& texture : scene.textures) {
        texture.image = asset.images.at(texture.image).slot;
        asset.textures.push_back(state.add(texture));
    }
    for (Material& material : scene.materials) {
        for (TextureRef* reference : material.textures()) {
            if (reference->present()) {
                reference->texture = asset.textures.at(reference->texture).slot;
            }
        }
        asset.materials.push_back(state.add(std::move(material)));
    }
    for (Mesh& mesh : scene.meshes) {
        mesh.material = asset.materials.at(mesh.material).slot;
        asset.meshes.push_back(state.add(std::move(mesh)));
    }
    asset.nodes = std::move(scene.nodes);
    asset.cameras = std::move(scene.cameras);
    asset.lights = std::move(scene.lights);
    asset.skies = std::move(scene.skies);
    asset.skins = std::move(scene.skins);
    if (!scene.animations.empty()) {
        asset.clips = std::make_shared<const std::vector<AnimationClip>>(std::move(scene.animations));
    }
    return state.add(std::move(asset));
}

}  // namespace lanthorn
