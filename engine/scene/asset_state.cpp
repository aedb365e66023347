#include "engine/scene/asset_state.h"

#include "lanthorn/scene/asset_hold.h"

namespace lanthorn {

namespace detail {

std::string described_asset(std::size_t kind, std::size_t slot, const std::string& name) {
    const std::string line = std::string(kAssetKinds.at(kind)) + " " + std::to_string(slot);
    return name.empty() ? line : line + " '" + name + "'";
}

void throw_no_asset(std::size_t kind, std::uint32_t slot, std::uint32_t generation, std::size_t size,
                    const std::uint32_t* present) {
    std::string line = described_asset(kind, slot, "") + " of generation " + std::to_string(generation) +
                       " is not in the store: ";
    if (slot == MeshHandle::kNobody) {
        line = std::string("a null handle to a ") + kAssetKinds.at(kind) + ": ";
    } else if (slot >= size) {
        line += "no such slot; ";
    } else if (present == nullptr) {
        line += "it has been released; ";
    } else {
        line += "it has been released, and generation " + std::to_string(*present) + " took the slot; ";
    }
    throw InputError(line + "expected the handle of an asset that somebody refers to");
}

}  // namespace detail

void AssetState::retexture(std::uint32_t texture) {
    const std::uint64_t next = next_asset_version();
    for (std::size_t slot = 0; slot < assets.materials.size(); ++slot) {
        if (assets.materials.has(slot)) {
            const auto version =
                assets.materials.version(slot).retextured(assets.materials[slot], texture, next);
            assets.materials.put(slot, assets.materials.shared(slot), version);
        }
    }
    changed();
}

template <class T>
void AssetHold<T>::refer() const {
    state_->refer<T>(asset_.slot);
}
template <class T>
void AssetHold<T>::let_go() const noexcept {
    state_->let_go<T>(asset_.slot);
}

template class AssetHold<Mesh>;
template class AssetHold<Material>;
template class AssetHold<Texture>;
template class AssetHold<Image>;
template class AssetHold<SceneAsset>;

}  // namespace lanthorn
