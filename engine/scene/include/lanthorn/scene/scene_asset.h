// A file as it is kept for spawning: its nodes, and which assets of the store are its meshes.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/scene/asset_handle.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

struct SceneAsset {
    std::string source;                                       // SceneData::source
    std::array<std::uint64_t, 2> digest{};                    // of all that follows, as it was loaded
    FileMap file;                                             // SceneData::file
    std::vector<NodeData> nodes;                              // NodeData::meshes: into `meshes`
    std::vector<std::vector<float>> weights;                  // by node: what its morph targets start with
    std::vector<Camera> cameras;                              // as SceneData's
    std::vector<Light> lights;                                // likewise
    std::vector<Sky> skies;                                   // likewise
    std::vector<Skin> skins;                                  // likewise
    std::shared_ptr<const std::vector<AnimationClip>> clips;  // null: none
    std::vector<MeshHandle> meshes;                           // by index into SceneData's
    std::vector<MaterialHandle> materials;                    // likewise
    std::vector<TextureHandle> textures;                      // likewise
    std::vector<ImageHandle> images;                          // likewise
};

}  // namespace lanthorn
