// AssetHold: keeps one asset of an AssetStore from being released, for as long as it or a copy of it lives.
//
//   const AssetHold<SceneAsset> kept = asset_store(world).hold(scene);   // spawn it again later
//
// Entities have theirs in MeshInstances and Source, put there by the hooks of those components, so that
// copies of components (clones, snapshots) count as well. It may outlive the store: then it keeps the assets
// of a store that no longer exists. Not thread-safe, as the store is not.
#pragma once

#include <memory>
#include <utility>

#include "lanthorn/scene/asset_handle.h"

namespace lanthorn {

class AssetStore;
struct AssetState;

// T: Mesh, Material, Texture, Image or SceneAsset. Copying and destroying are O(1), but for the last of an
// asset: that releases it and what it alone referred to.
template <class T>
class AssetHold {
  public:
    AssetHold() = default;  // of nothing
    AssetHold(const AssetHold& other) : state_(other.state_), asset_(other.asset_) {
        if (state_) {
            refer();
        }
    }
    AssetHold(AssetHold&& other) noexcept = default;
    AssetHold& operator=(AssetHold other) noexcept {
        std::swap(state_, other.state_);
        std::swap(asset_, other.asset_);
        return *this;
    }
    ~AssetHold() {
        if (state_) {
            let_go();
        }
    }

    explicit operator bool() const { return state_ != nullptr; }
    AssetHandle<T> asset() const { return state_ ? asset_ : AssetHandle<T>{}; }  // null: it holds nothing

  private:
    friend AssetStore;
    AssetHold(std::shared_ptr<AssetState> state, AssetHandle<T> asset)
        : state_(std::move(state)), asset_(asset) {
        refer();
    }
    void refer() const;
    void let_go() const noexcept;

    std::shared_ptr<AssetState> state_;  // null: of nothing
    AssetHandle<T> asset_;
};

}  // namespace lanthorn
