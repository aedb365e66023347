// Handles to assets: numbers, like entities, that may be copied, compared, hashed and written to a file.
#pragma once

#include <compare>
#include <cstdint>

namespace lanthorn {

// A slot of a table of assets, and which of the assets that the slot has held. The handle of an asset that
// has been released stays different from those of all that come to the slot later.
template <class T>
struct AssetHandle {
    static constexpr std::uint32_t kNobody = 0xffffffffu;

    std::uint32_t slot = kNobody;
    std::uint32_t generation = 0;

    explicit operator bool() const { return slot != kNobody; }  // names an asset, which may be gone
    auto operator<=>(const AssetHandle&) const = default;
};

struct Mesh;
struct Material;
struct Texture;
struct Image;
struct SceneAsset;

using MeshHandle = AssetHandle<Mesh>;
using MaterialHandle = AssetHandle<Material>;
using TextureHandle = AssetHandle<Texture>;
using ImageHandle = AssetHandle<Image>;
using SceneHandle = AssetHandle<SceneAsset>;

}  // namespace lanthorn
