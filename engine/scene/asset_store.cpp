#include "lanthorn/scene/asset_store.h"

#include <type_traits>
#include <utility>
#include <vector>

#include "engine/scene/asset_scenes.h"
#include "engine/scene/asset_state.h"

namespace lanthorn {

namespace {

template <class T>
AssetHandle<T> add_checked(AssetState& state, T asset) {
    state.check(state.table<T>().size(), asset);
    return state.add(std::move(asset));
}

template <class T>
std::shared_ptr<T> altered(AssetState& state, AssetHandle<T> handle, const std::function<void(T&)>& alter) {
    auto copy = std::make_shared<T>(state.get(handle));
    alter(*copy);
    state.check(handle.slot, *copy);
    return copy;
}

}  // namespace

AssetStore::AssetStore() : state_(std::make_shared<AssetState>()) {}
AssetStore::AssetStore(AssetStore&&) noexcept = default;
AssetStore& AssetStore::operator=(AssetStore&&) noexcept = default;
AssetStore::~AssetStore() = default;

MeshHandle AssetStore::add(Mesh mesh) {
    return add_checked(*state_, std::move(mesh));
}
MaterialHandle AssetStore::add(Material material) {
    return add_checked(*state_, std::move(material));
}
TextureHandle AssetStore::add(Texture texture) {
    return add_checked(*state_, texture);
}
ImageHandle AssetStore::add(Image image) {
    return add_checked(*state_, std::move(image));
}
SceneHandle AssetStore::add(const SceneData& scene) {
    const SceneDigest digest = scene_digest(scene);
    const SceneHandle found = find_same_scene(*state_, scene, digest);
    return found ? found : join_scene(*state_, SceneData(scene), digest);
}
SceneHandle AssetStore::add(SceneData&& scene) {
    const SceneDigest digest = scene_digest(scene);
    const SceneHandle found = find_same_scene(*state_, scene, digest);
    return found ? found : join_scene(*state_, std::move(scene), digest);
}

SceneHandle AssetStore::find_scene(std::string_view source) const {
    const AssetTable<SceneAsset>& scenes = state_->scenes;
    SceneHandle found;
    for (std::size_t slot = 0; slot < scenes.size(); ++slot) {
        const bool named = scenes.has(slot) && scenes[slot].source == source;
        if (named && (!found || scenes.version(slot).any > scenes.version(found.slot).any)) {
            found = scenes.handle(slot);
        }
    }
    return found;
}

template <class T>
const T& AssetStore::get(AssetHandle<T> asset) const {
    return state_->get(asset);
}
template <class T>
bool AssetStore::alive(AssetHandle<T> asset) const {
    return state_->table<T>().find(asset) != nullptr;
}
MaterialHandle AssetStore::material_of(MeshHandle mesh) const {
    return state_->assets.materials.handle(get(mesh).material);
}
TextureHandle AssetStore::texture_handle(const TextureRef& reference) const {
    return reference.present() ? state_->assets.textures.handle(reference.texture) : TextureHandle{};
}
ImageHandle AssetStore::image_of(TextureHandle texture) const {
    return state_->assets.images.handle(get(texture).image);
}

// Puts `now`, which is checked, in the asset's place.
template <class T>
AssetBefore<T> AssetStore::put(AssetHandle<T> asset, std::shared_ptr<const T> now) {
    const AssetTable<T>& table = state_->table<T>();
    AssetBefore<T> before{asset, table.version(asset.slot), table.shared(asset.slot), nullptr};
    auto held = std::make_shared<std::vector<std::shared_ptr<const void>>>();
    AssetState::each_used(*before.value, [&]<class Used>(std::uint32_t slot) {
        held->push_back(std::make_shared<AssetHold<Used>>(hold(state_->table<Used>().handle(slot))));
    });
    before.held = std::move(held);
    AssetVersion<T> version(next_asset_version());
    if constexpr (std::is_same_v<T, Material>) {
        version = before.version.edited(*before.value, *now, version.any);
    }
    state_->replace<T>(asset.slot, std::move(now), version);
    if constexpr (std::is_same_v<T, Texture>) {
        state_->retexture(asset.slot);
    }
    if constexpr (std::is_same_v<T, Image>) {
        const AssetTable<Texture>& textures = state_->assets.textures;
        for (std::uint32_t slot = 0; slot < textures.size(); ++slot) {
            if (textures.has(slot) && textures[slot].image == asset.slot) {
                state_->retexture(slot);
            }
        }
    }
    return before;
}

AssetBefore<Mesh> AssetStore::edit_mesh(MeshHandle mesh, const std::function<void(Mesh&)>& alter) {
    const std::shared_ptr<Mesh> now = altered(*state_, mesh, alter);
    now->bounds = {};
    for (const Vertex& vertex : now->vertices) {
        now->bounds.add(vertex.position);
    }
    return put<Mesh>(mesh, now);
}

AssetBefore<Material> AssetStore::edit_material(MaterialHandle material,
                                                const std::function<void(Material&)>& alter) {
    return put<Material>(material, altered(*state_, material, alter));
}

AssetBefore<Texture> AssetStore::edit_texture(TextureHandle texture,
                                              const std::function<void(Texture&)>& alter) {
    return put<Texture>(texture, altered(*state_, texture, alter));
}

AssetBefore<Image> AssetStore::edit_image(ImageHandle image, const std::function<void(Image&)>& alter) {
    return put<Image>(image, altered(*state_, image, alter));
}

template <class T>
AssetBefore<T> AssetStore::restore(const AssetBefore<T>& before) {
    get(before.asset);
    state_->check(before.asset.slot, *before.value);
    return put<T>(before.asset, before.value);
}
template AssetBefore<Mesh> AssetStore::restore(const AssetBefore<Mesh>&);
template AssetBefore<Material> AssetStore::restore(const AssetBefore<Material>&);
template AssetBefore<Texture> AssetStore::restore(const AssetBefore<Texture>&);
template AssetBefore<Image> AssetStore::restore(const AssetBefore<Image>&);

template <class T>
AssetHold<T> AssetStore::hold(AssetHandle<T> asset) const {
    get(asset);
    return AssetHold<T>(state_, asset);
}
template <class T>
void AssetStore::retain(AssetHandle<T> asset) {
    get(asset);
    state_->refer<T>(asset.slot);
}
template <class T>
void AssetStore::release(AssetHandle<T> asset) {
    get(asset);
    state_->let_go<T>(asset.slot);
}
template <class T>
std::size_t AssetStore::references(AssetHandle<T> asset) const {
    get(asset);
    return state_->counts<T>()[asset.slot];
}

void AssetStore::discard() {
    state_->discard<SceneAsset>();
    state_->discard<Mesh>();
    state_->discard<Material>();
    state_->discard<Texture>();
    state_->discard<Image>();
}

std::shared_ptr<const SceneAssets> AssetStore::snapshot() const {
    const std::lock_guard lock(state_->snapshot_mutex);
    if (!state_->snapshot) {
        state_->snapshot = std::make_shared<const SceneAssets>(state_->assets);
    }
    return state_->snapshot;
}

const SceneAssets& AssetStore::assets() const {
    return state_->assets;
}

AssetStore& asset_store(ecs::World& world) {
    if (world.try_resource<AssetStore>() == nullptr) {
        world.insert_resource(AssetStore());
    }
    return world.resource_mut<AssetStore>();
}

// What the header's templates are for.
#define LANTHORN_ASSET_KIND(T)                                    \
    template const T& AssetStore::get(AssetHandle<T>) const;      \
    template bool AssetStore::alive(AssetHandle<T>) const;        \
    template AssetHold<T> AssetStore::hold(AssetHandle<T>) const; \
    template void AssetStore::retain(AssetHandle<T>);             \
    template void AssetStore::release(AssetHandle<T>);            \
    template std::size_t AssetStore::references(AssetHandle<T>) const;
LANTHORN_ASSET_KIND(Mesh)
LANTHORN_ASSET_KIND(Material)
LANTHORN_ASSET_KIND(Texture)
LANTHORN_ASSET_KIND(Image)
LANTHORN_ASSET_KIND(SceneAsset)
#undef LANTHORN_ASSET_KIND

}  // namespace lanthorn
