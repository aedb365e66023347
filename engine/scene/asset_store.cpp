#include "lanthorn/scene/asset_store.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <queue>
#include <utility>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/asset_check.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/scene_digest.h"

namespace lanthorn {

namespace {

const char* kind(const AssetTable<Mesh>&) {
    return "mesh";
}
const char* kind(const AssetTable<Material>&) {
    return "material";
}
const char* kind(const AssetTable<Texture>&) {
    return "texture";
}
const char* kind(const AssetTable<Image>&) {
    return "image";
}
const char* kind(const AssetTable<SceneAsset>&) {
    return "scene";
}

std::string name_of(const Texture&) {
    return {};
}
template <class T>
std::string name_of(const T& asset) {
    return asset.name;
}

template <class T>
std::string described(const AssetTable<T>& table, std::size_t slot, const std::string& name) {
    std::string line = std::string(kind(table)) + " " + std::to_string(slot);
    return name.empty() ? line : line + " '" + name + "'";
}

template <class T>
[[noreturn]] void throw_gone(const AssetTable<T>& table, AssetHandle<T> handle) {
    std::string line = described(table, handle.slot, "") + " of generation " +
                       std::to_string(handle.generation) + " is not in the store: ";
    if (!handle) {
        line = std::string("a null handle to a ") + kind(table) + ": ";
    } else if (handle.slot >= table.size()) {
        line += "no such slot; ";
    } else if (!table.has(handle.slot)) {
        line += "it has been released; ";
    } else {
        line += "it has been released, and generation " +
                std::to_string(table.handle(handle.slot).generation) + " took the slot; ";
    }
    throw InputError(line + "expected the handle of an asset that somebody refers to");
}

// How many refer to each slot of a table, and which slots are free: the lowest serves next.
class Counts {
  public:
    template <class T>
    std::uint32_t take(const AssetTable<T>& table) {
        std::size_t slot = table.size();
        if (!free_.empty()) {
            slot = free_.top();
            free_.pop();
        }
        counts_.resize(std::max(counts_.size(), slot + 1), 0);
        counts_[slot] = 0;
        return static_cast<std::uint32_t>(slot);
    }
    void free(std::uint32_t slot) { free_.push(slot); }
    std::size_t& operator[](std::uint32_t slot) { return counts_[slot]; }

  private:
    std::vector<std::size_t> counts_;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_;
};

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

struct AssetStore::State {
    SceneAssets assets;
    AssetTable<SceneAsset> scenes;
    Counts mesh_counts, material_counts, texture_counts, image_counts, scene_counts;
    mutable std::mutex snapshot_mutex;
    mutable std::shared_ptr<const SceneAssets> snapshot;

    Counts& counts(const AssetTable<Mesh>&) { return mesh_counts; }
    Counts& counts(const AssetTable<Material>&) { return material_counts; }
    Counts& counts(const AssetTable<Texture>&) { return texture_counts; }
    Counts& counts(const AssetTable<Image>&) { return image_counts; }
    Counts& counts(const AssetTable<SceneAsset>&) { return scene_counts; }

    void changed() {
        assets.serial = next_asset_version();
        snapshot.reset();
    }

    // Calls `use` with the table and slot of each asset that the given one refers to.
    template <class Use>
    void each_used(const Mesh& mesh, const Use& use) {
        use(assets.materials, mesh.material);
    }
    template <class Use>
    void each_used(const Material& material, const Use& use) {
        for (const TextureRef* reference : material.textures()) {
            if (reference->present()) {
                use(assets.textures, reference->texture);
            }
        }
    }
    template <class Use>
    void each_used(const Texture& texture, const Use& use) {
        use(assets.images, texture.image);
    }
    template <class Use>
    void each_used(const Image&, const Use&) {}
    template <class Use>
    void each_used(const SceneAsset& scene, const Use& use) {
        std::ranges::for_each(scene.meshes, [&](MeshHandle h) { use(assets.meshes, h.slot); });
        std::ranges::for_each(scene.materials, [&](MaterialHandle h) { use(assets.materials, h.slot); });
        std::ranges::for_each(scene.textures, [&](TextureHandle h) { use(assets.textures, h.slot); });
        std::ranges::for_each(scene.images, [&](ImageHandle h) { use(assets.images, h.slot); });
    }

    template <class T>
    void refer(AssetTable<T>& table, std::uint32_t slot) {
        ++counts(table)[slot];
    }
    template <class T>
    void let_go(AssetTable<T>& table, std::uint32_t slot) {
        if (--counts(table)[slot] == 0) {
            drop(table, slot);
        }
    }
    template <class T>
    void drop(AssetTable<T>& table, std::uint32_t slot) {
        const std::shared_ptr<const T> asset = table.shared(slot);
        table.release(slot);
        counts(table).free(slot);
        changed();
        each_used(*asset, [&](auto& used, std::uint32_t its_slot) { let_go(used, its_slot); });
    }

    template <class T>
    void check(const AssetTable<T>& table, std::size_t slot, const T& asset) const {
        if (const std::string problem = problem_of(asset, assets); !problem.empty()) {
            throw InputError(described(table, slot, name_of(asset)) + ": " + problem);
        }
    }

    template <class T>
    AssetHandle<T> add(AssetTable<T>& table, T asset) {
        const std::uint32_t slot = counts(table).take(table);
        each_used(asset, [&](auto& used, std::uint32_t its_slot) { refer(used, its_slot); });
        table.put(slot, std::make_shared<const T>(std::move(asset)), AssetVersion<T>(next_asset_version()));
        changed();
        return table.handle(slot);
    }
    template <class T>
    AssetHandle<T> add_checked(AssetTable<T>& table, T asset) {
        check(table, table.size(), asset);
        return add(table, std::move(asset));
    }

    template <class T>
    const T& get(const AssetTable<T>& table, AssetHandle<T> handle) const {
        const T* asset = table.find(handle);
        if (asset == nullptr) {
            throw_gone(table, handle);
        }
        return *asset;
    }

    // Puts `now` in the place of what the handle names.
    template <class T>
    void replace(AssetTable<T>& table, std::uint32_t slot, std::shared_ptr<const T> now,
                 const AssetVersion<T>& version) {
        const std::shared_ptr<const T> before = table.shared(slot);
        each_used(*now, [&](auto& used, std::uint32_t its_slot) { refer(used, its_slot); });
        table.put(slot, now, version);
        changed();
        each_used(*before, [&](auto& used, std::uint32_t its_slot) { let_go(used, its_slot); });
    }
    template <class T>
    std::shared_ptr<T> altered(const AssetTable<T>& table, AssetHandle<T> handle,
                               const std::function<void(T&)>& alter) const {
        auto copy = std::make_shared<T>(get(table, handle));
        alter(*copy);
        check(table, handle.slot, *copy);
        return copy;
    }
    void retexture(std::uint32_t texture) {
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
    void discard(AssetTable<T>& table) {
        for (std::uint32_t slot = 0; slot < table.size(); ++slot) {
            if (table.has(slot) && counts(table)[slot] == 0) {
                drop(table, slot);
            }
        }
    }

    SceneHandle find(const SceneData& scene, const std::array<std::uint64_t, 2>& digest) const {
        for (std::size_t slot = 0; slot < scenes.size(); ++slot) {
            if (scenes.has(slot) && scenes[slot].digest == digest && scenes[slot].source == scene.source) {
                return scenes.handle(slot);
            }
        }
        return {};
    }
    SceneHandle join(SceneData&& scene, const std::array<std::uint64_t, 2>& digest);
};

// What importers yield is as they say; indices become slots.
SceneHandle AssetStore::State::join(SceneData&& scene, const std::array<std::uint64_t, 2>& digest) {
    SceneAsset asset;
    asset.source = std::move(scene.source);
    asset.digest = digest;
    for (const NodeData& node : scene.nodes) {
        asset.weights.push_back(start_weights(node, scene.meshes));
    }
    for (Image& image : scene.images) {
        asset.images.push_back(add(assets.images, std::move(image)));
    }
    for (Texture& texture : scene.textures) {
        texture.image = asset.images.at(texture.image).slot;
        asset.textures.push_back(add(assets.textures, texture));
    }
    for (Material& material : scene.materials) {
        for (TextureRef* reference : material.textures()) {
            if (reference->present()) {
                reference->texture = asset.textures.at(reference->texture).slot;
            }
        }
        asset.materials.push_back(add(assets.materials, std::move(material)));
    }
    for (Mesh& mesh : scene.meshes) {
        mesh.material = asset.materials.at(mesh.material).slot;
        asset.meshes.push_back(add(assets.meshes, std::move(mesh)));
    }
    asset.nodes = std::move(scene.nodes);
    asset.cameras = std::move(scene.cameras);
    asset.lights = std::move(scene.lights);
    asset.skins = std::move(scene.skins);
    if (!scene.animations.empty()) {
        asset.clips = std::make_shared<const std::vector<AnimationClip>>(std::move(scene.animations));
    }
    return add(scenes, std::move(asset));
}

AssetStore::AssetStore() : state_(std::make_shared<State>()) {}
AssetStore::AssetStore(AssetStore&&) noexcept = default;
AssetStore& AssetStore::operator=(AssetStore&&) noexcept = default;
AssetStore::~AssetStore() = default;

MeshHandle AssetStore::add(Mesh mesh) {
    return state_->add_checked(state_->assets.meshes, std::move(mesh));
}
MaterialHandle AssetStore::add(Material material) {
    return state_->add_checked(state_->assets.materials, std::move(material));
}
TextureHandle AssetStore::add(Texture texture) {
    return state_->add_checked(state_->assets.textures, texture);
}
ImageHandle AssetStore::add(Image image) {
    return state_->add_checked(state_->assets.images, std::move(image));
}
SceneHandle AssetStore::add(const SceneData& scene) {
    const auto digest = scene_digest(scene);
    const SceneHandle found = state_->find(scene, digest);
    return found ? found : state_->join(SceneData(scene), digest);
}
SceneHandle AssetStore::add(SceneData&& scene) {
    const auto digest = scene_digest(scene);
    const SceneHandle found = state_->find(scene, digest);
    return found ? found : state_->join(std::move(scene), digest);
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

const Mesh& AssetStore::get(MeshHandle mesh) const {
    return state_->get(state_->assets.meshes, mesh);
}
const Material& AssetStore::get(MaterialHandle material) const {
    return state_->get(state_->assets.materials, material);
}
const Texture& AssetStore::get(TextureHandle texture) const {
    return state_->get(state_->assets.textures, texture);
}
const Image& AssetStore::get(ImageHandle image) const {
    return state_->get(state_->assets.images, image);
}
const SceneAsset& AssetStore::get(SceneHandle scene) const {
    return state_->get(state_->scenes, scene);
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
bool AssetStore::alive(SceneHandle scene) const {
    return state_->scenes.find(scene) != nullptr;
}

void AssetStore::edit_mesh(MeshHandle mesh, const std::function<void(Mesh&)>& alter) {
    auto& table = state_->assets.meshes;
    const std::shared_ptr<Mesh> now = state_->altered(table, mesh, alter);
    now->bounds = {};
    for (const Vertex& vertex : now->vertices) {
        now->bounds.add(vertex.position);
    }
    state_->replace(table, mesh.slot, std::shared_ptr<const Mesh>(now),
                    AssetVersion<Mesh>(next_asset_version()));
}

void AssetStore::edit_material(MaterialHandle material, const std::function<void(Material&)>& alter) {
    auto& table = state_->assets.materials;
    const std::shared_ptr<const Material> now = state_->altered(table, material, alter);
    const AssetVersion<Material> version =
        table.version(material.slot).edited(table[material.slot], *now, next_asset_version());
    state_->replace(table, material.slot, now, version);
}

void AssetStore::edit_texture(TextureHandle texture, const std::function<void(Texture&)>& alter) {
    auto& table = state_->assets.textures;
    const std::shared_ptr<const Texture> now = state_->altered(table, texture, alter);
    state_->replace(table, texture.slot, now, AssetVersion<Texture>(next_asset_version()));
    state_->retexture(texture.slot);
}

void AssetStore::edit_image(ImageHandle image, const std::function<void(Image&)>& alter) {
    SceneAssets& assets = state_->assets;
    const std::shared_ptr<const Image> now = state_->altered(assets.images, image, alter);
    state_->replace(assets.images, image.slot, now, AssetVersion<Image>(next_asset_version()));
    for (std::uint32_t slot = 0; slot < assets.textures.size(); ++slot) {
        if (assets.textures.has(slot) && assets.textures[slot].image == image.slot) {
            state_->retexture(slot);
        }
    }
}

void AssetStore::retain(MeshHandle mesh) {
    get(mesh);
    state_->refer(state_->assets.meshes, mesh.slot);
}
void AssetStore::retain(MaterialHandle material) {
    get(material);
    state_->refer(state_->assets.materials, material.slot);
}
void AssetStore::retain(SceneHandle scene) {
    get(scene);
    state_->refer(state_->scenes, scene.slot);
}
void AssetStore::release(MeshHandle mesh) {
    get(mesh);
    state_->let_go(state_->assets.meshes, mesh.slot);
}
void AssetStore::release(MaterialHandle material) {
    get(material);
    state_->let_go(state_->assets.materials, material.slot);
}
void AssetStore::release(SceneHandle scene) {
    get(scene);
    state_->let_go(state_->scenes, scene.slot);
}

std::size_t AssetStore::references(MeshHandle mesh) const {
    get(mesh);
    return state_->mesh_counts[mesh.slot];
}
std::size_t AssetStore::references(MaterialHandle material) const {
    get(material);
    return state_->material_counts[material.slot];
}
std::size_t AssetStore::references(TextureHandle texture) const {
    get(texture);
    return state_->texture_counts[texture.slot];
}
std::size_t AssetStore::references(ImageHandle image) const {
    get(image);
    return state_->image_counts[image.slot];
}
std::size_t AssetStore::references(SceneHandle scene) const {
    get(scene);
    return state_->scene_counts[scene.slot];
}

void AssetStore::discard() {
    state_->discard(state_->scenes);
    state_->discard(state_->assets.meshes);
    state_->discard(state_->assets.materials);
    state_->discard(state_->assets.textures);
    state_->discard(state_->assets.images);
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

}  // namespace lanthorn
