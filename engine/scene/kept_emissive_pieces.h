// Pieces that meshes glow in, kept from frame to frame: a cut is a look at up to a million texels.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/scene/emissive_pieces.h"

namespace lanthorn {

class KeptEmissivePieces {
  public:
    // Of the mesh in that slot, which must be occupied; null if it glows evenly or not at all. Cut again if
    // the mesh has changed since, or what its material shows where: the emissive texture, and as far as alpha
    // counts the base colour's. How bright it is does not tell. O(1), or a cut (emissive_pieces()).
    std::shared_ptr<const EmissivePieces> of(const SceneAssets& assets, std::uint32_t mesh);

  private:
    struct Shown {
        TextureRef reference;
        std::uint64_t texture = 0, image = 0;  // versions
        bool operator==(const Shown&) const = default;
    };
    // What a cut goes by.
    struct Key {
        std::uint64_t mesh = 0;  // AssetVersion<Mesh>
        AlphaMode alpha_mode = AlphaMode::opaque;
        float cutoff = 0, alpha = 0;  // of masked ones
        Shown emission, base;
        bool operator==(const Key&) const = default;
    };
    struct Kept {
        Key key;
        std::shared_ptr<const EmissivePieces> pieces;
    };
    static Shown shown(const SceneAssets& assets, const TextureRef& reference);
    static Key key_of(const SceneAssets& assets, std::uint32_t mesh);

    std::vector<Kept> kept_;  // by slot of the meshes
};

}  // namespace lanthorn
