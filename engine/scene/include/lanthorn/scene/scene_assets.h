// What the instances of a FrameScene refer to: a snapshot that many frames share and that never changes.
#pragma once

#include <cstdint>

#include "lanthorn/scene/asset_table.h"
#include "lanthorn/scene/material.h"
#include "lanthorn/scene/mesh.h"

namespace lanthorn {

// Mesh::material, TextureRef::texture and Texture::image are slots of these tables, always occupied.
struct SceneAssets {
    std::uint64_t serial = next_asset_version();  // another one whenever any table differs
    AssetTable<Mesh> meshes;
    AssetTable<Material> materials;
    AssetTable<Texture> textures;
    AssetTable<Image> images;
};

}  // namespace lanthorn
