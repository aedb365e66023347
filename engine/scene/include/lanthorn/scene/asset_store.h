// AssetStore: the meshes, materials, textures, images and files of a world, each once, by handle.
//
// Assets are counted: an entity's MeshInstances refer to meshes, a mesh to its material, a material to
// textures, a texture to its image, an entity's Source to the file that it came from, and that to all that
// was in it. The hooks of MeshInstances and Source count; an ecs::Snapshot holds what its entities showed,
// for as long as it lives. What has been referred to and no longer is, is released at once; its slot serves
// again and its handle is an error from then on. What has not been referred to yet stays until discard().
//
// Snapshots of the assets share them: a snapshot never shows a later change. Not thread-safe, but for
// snapshot().
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/asset_hold.h"
#include "lanthorn/scene/scene_asset.h"
#include "lanthorn/scene/scene_assets.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// An asset as it was before an edit, to go back to: shared with the snapshots that show it, so that it costs
// no copy. It holds what the asset referred to, so that none of that is released. T: Mesh, Material, Texture
// or Image.
template <class T>
struct AssetBefore {
    AssetHandle<T> asset;
    AssetVersion<T> version;         // that it had then
    std::shared_ptr<const T> value;  // never null
    std::shared_ptr<const void> held;
};

class AssetStore {
  public:
    AssetStore();
    AssetStore(AssetStore&&) noexcept;
    AssetStore& operator=(AssetStore&&) noexcept;
    ~AssetStore();

    // Adding. Indices inside the asset (Mesh::material, ...) are slots of this store. Throws InputError for
    // one that cannot be drawn: indices out of range, numbers that are not finite. O(data) for meshes.
    MeshHandle add(Mesh mesh);
    // Colours of 0 or more, factors in their ranges, textures of this store.
    MaterialHandle add(Material material);
    // Of an image of this store.
    TextureHandle add(Texture texture);
    // Of as many bytes as its size says, or of none.
    ImageHandle add(Image image);
    // A loaded scene and all that is in it. The same source with the same content is shared, as it is now
    // with its edits: O(data) to compare. The second form takes the assets out of `scene`.
    SceneHandle add(const SceneData& scene);
    // Takes the assets out of `scene`.
    SceneHandle add(SceneData&& scene);
    // The file of that name that was added last; a null handle if none was. O(files).
    SceneHandle find_scene(std::string_view source) const;

    // Looking, at a Mesh, Material, Texture, Image or SceneAsset. All but alive() throw InputError, one line,
    // for a handle of what has been released or never was. O(1).
    template <class T>
    const T& get(AssetHandle<T> asset) const;
    template <class T>
    bool alive(AssetHandle<T> asset) const;  // not yet released
    // Of the mesh as it is now.
    MaterialHandle material_of(MeshHandle mesh) const;
    TextureHandle texture_handle(const TextureRef& reference) const;  // null: it has none
    // Of the texture as it is now.
    ImageHandle image_of(TextureHandle texture) const;

    // Editing: `alter` gets a copy, which takes the asset's place under the same handle, of another version
    // in what differs. Throws like add(), and then nothing has changed. O(data) of the asset; the bounds of a
    // mesh are found again. Returns what was there before.
    AssetBefore<Mesh> edit_mesh(MeshHandle mesh, const std::function<void(Mesh&)>& alter);
    // As edit_mesh(). Copies no texture.
    AssetBefore<Material> edit_material(MaterialHandle material, const std::function<void(Material&)>& alter);
    // As edit_mesh(). Copies no image.
    AssetBefore<Texture> edit_texture(TextureHandle texture, const std::function<void(Texture&)>& alter);
    // As edit_mesh(). Copies the pixels: O(pixels).
    AssetBefore<Image> edit_image(ImageHandle image, const std::function<void(Image&)>& alter);
    // Undoes an edit, under the same handle and of another version in what differs; what it returns undoes
    // that again. Copies nothing. Throws InputError for an asset that has been released.
    template <class T>
    AssetBefore<T> restore(const AssetBefore<T>& before);

    // Holding beside entities: by an object that lets go when it dies, or by hand, where each retain() wants
    // a release(). Throw like get().
    template <class T>
    AssetHold<T> hold(AssetHandle<T> asset) const;
    // By hand: one more holds it.
    template <class T>
    void retain(AssetHandle<T> asset);
    // By hand: one less holds it; with the last it may go. One call to each retain(), and none without.
    template <class T>
    void release(AssetHandle<T> asset);
    // How many refer to it: entities, other assets, holds, and copies of components in snapshots.
    template <class T>
    std::size_t references(AssetHandle<T> asset) const;
    // Whether the hold is on an asset of this store.
    template <class T>
    bool holds(const AssetHold<T>& hold) const {
        return hold.state_ == state_;
    }
    // Releases what has not been referred to yet. O(assets).
    void discard();

    // As the assets are now. Taken once for all that ask until something changes: O(slots) then, O(1) else.
    std::shared_ptr<const SceneAssets> snapshot() const;
    // The same to look at, valid until the next change.
    const SceneAssets& assets() const;

  private:
    template <class T>
    AssetBefore<T> put(AssetHandle<T> asset, std::shared_ptr<const T> now);

    std::shared_ptr<AssetState> state_;
};

// The world's store, a resource; made when first asked for.
AssetStore& asset_store(ecs::World& world);

}  // namespace lanthorn
