// What is in an AssetStore: its tables, and who refers to what. Shared by the store and all AssetHolds.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/scene/asset_check.h"
#include "engine/scene/asset_counts.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/scene_asset.h"
#include "lanthorn/scene/scene_assets.h"

namespace lanthorn {

namespace detail {

inline constexpr std::array kAssetKinds{"mesh", "material", "texture", "image", "scene"};

// Into kAssetKinds.
template <class T>
constexpr std::size_t asset_kind() {
    constexpr std::array same{std::is_same_v<T, Mesh>, std::is_same_v<T, Material>,
                              std::is_same_v<T, Texture>, std::is_same_v<T, Image>,
                              std::is_same_v<T, SceneAsset>};
    constexpr auto found = static_cast<std::size_t>(std::find(same.begin(), same.end(), true) - same.begin());
    static_assert(found < kAssetKinds.size());
    return found;
}

// "mesh 3 'door'".
std::string described_asset(std::size_t kind, std::size_t slot, const std::string& name);

// `size`: of the table. `present`: the generation of what is in the slot; null: it is free.
[[noreturn]] void throw_no_asset(std::size_t kind, std::uint32_t slot, std::uint32_t generation,
                                 std::size_t size, const std::uint32_t* present);

}  // namespace detail

struct AssetState {
    SceneAssets assets;
    AssetTable<SceneAsset> scenes;
    std::array<AssetCounts, detail::kAssetKinds.size()> counts_by_kind;
    std::mutex snapshot_mutex;
    std::shared_ptr<const SceneAssets> snapshot;

    template <class T>
    AssetTable<T>& table() {
        if constexpr (std::is_same_v<T, Mesh>) {
            return assets.meshes;
        } else if constexpr (std::is_same_v<T, Material>) {
            return assets.materials;
        } else if constexpr (std::is_same_v<T, Texture>) {
            return assets.textures;
        } else if constexpr (std::is_same_v<T, Image>) {
            return assets.images;
        } else {
            return scenes;
        }
    }
    template <class T>
    AssetCounts& counts() {
        return counts_by_kind[detail::asset_kind<T>()];
    }

    // Calls use(handle's type, slot) as use.template operator()<T>(slot) for each asset that the given one
    // refers to.
    template <class Use>
    static void each_used(const Mesh& mesh, const Use& use) {
        use.template operator()<Material>(mesh.material);
    }
    template <class Use>
    static void each_used(const Material& material, const Use& use) {
        for (const TextureRef* reference : material.textures()) {
            if (reference->present()) {
                use.template operator()<Texture>(reference->texture);
            }
        }
    }
    template <class Use>
    static void each_used(const Texture& texture, const Use& use) {
        use.template operator()<Image>(texture.image);
    }
    template <class Use>
    static void each_used(const Image&, const Use&) {}
    template <class Use>
    static void each_used(const SceneAsset& scene, const Use& use) {
        const auto all = [&]<class T>(const std::vector<AssetHandle<T>>& handles) {
            for (const AssetHandle<T> handle : handles) {
                use.template operator()<T>(handle.slot);
            }
        };
        all(scene.meshes);
        all(scene.materials);
        all(scene.textures);
        all(scene.images);
    }

    template <class T>
    void refer(std::uint32_t slot) {
        ++counts<T>()[slot];
    }
    template <class T>
    void refer_to_used(const T& asset) {
        each_used(asset, [this]<class Used>(std::uint32_t slot) { this->template refer<Used>(slot); });
    }
    template <class T>
    void let_go_of_used(const T& asset) {
        each_used(asset, [this]<class Used>(std::uint32_t slot) { this->template let_go<Used>(slot); });
    }
    // Releases what nobody refers to any more.
    template <class T>
    void let_go(std::uint32_t slot) {
        if (--counts<T>()[slot] == 0) {
            drop<T>(slot);
        }
    }
    template <class T>
    void drop(std::uint32_t slot) {
        const std::shared_ptr<const T> asset = table<T>().shared(slot);
        table<T>().release(slot);
        counts<T>().free(slot);
        changed();
        let_go_of_used(*asset);
    }
    // Drops what nobody has referred to yet.
    template <class T>
    void discard() {
        for (std::uint32_t slot = 0; slot < table<T>().size(); ++slot) {
            if (table<T>().has(slot) && counts<T>()[slot] == 0) {
                drop<T>(slot);
            }
        }
    }

    // Throws InputError for the handle of what has been released or never was.
    template <class T>
    const T& get(AssetHandle<T> handle) {
        const AssetTable<T>& all = table<T>();
        const T* asset = all.find(handle);
        if (asset == nullptr) {
            const bool taken = all.has(handle.slot);
            const std::uint32_t present = taken ? all.handle(handle.slot).generation : 0;
            detail::throw_no_asset(detail::asset_kind<T>(), handle.slot, handle.generation, all.size(),
                                   taken ? &present : nullptr);
        }
        return *asset;
    }
    template <class T>
    AssetHandle<T> add(T asset) {
        const std::uint32_t slot = counts<T>().take(table<T>().size());
        refer_to_used(asset);
        table<T>().put(slot, std::make_shared<const T>(std::move(asset)),
                       AssetVersion<T>(next_asset_version()));
        changed();
        return table<T>().handle(slot);
    }
    // Puts `now` in the place of what is in the slot.
    template <class T>
    void replace(std::uint32_t slot, std::shared_ptr<const T> now, const AssetVersion<T>& version) {
        const std::shared_ptr<const T> before = table<T>().shared(slot);
        refer_to_used(*now);
        table<T>().put(slot, std::move(now), version);
        changed();
        let_go_of_used(*before);
    }
    // Throws InputError for an asset that cannot be drawn, which is or will be in the slot.
    template <class T>
    void check(std::size_t slot, const T& asset) const {
        if (const std::string problem = problem_of(asset, assets); !problem.empty()) {
            std::string name;
            if constexpr (requires { asset.name; }) {
                name = asset.name;
            }
            throw InputError(detail::described_asset(detail::asset_kind<T>(), slot, name) + ": " + problem);
        }
    }

    // The materials that show `texture` are of another version in what shows it.
    void retexture(std::uint32_t texture);
    void changed() {
        assets.serial = next_asset_version();
        snapshot.reset();
    }
};

}  // namespace lanthorn
