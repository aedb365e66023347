// AssetStore: the meshes, materials, textures, images and files of a world, each once, by handle.
//
// Assets are counted: an entity's MeshInstances refer to meshes, a mesh to its material, a material to
// textures, a texture to its image, an entity's Source to the file that it came from, and that to all that
// was in it. What has been referred to and no longer is, is released at once; its slot serves again and its
// handle is an error from then on. What nobody has referred to yet stays until discard().
//
// Snapshots share the assets: nobody who holds one sees an asset change. Not thread-safe, but for snapshot().
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/scene_asset.h"
#include "lanthorn/scene/scene_assets.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

class AssetStore {
  public:
    AssetStore();
    AssetStore(AssetStore&&) noexcept;
    AssetStore& operator=(AssetStore&&) noexcept;
    ~AssetStore();

    // Adding. Indices inside the asset (Mesh::material, ...) are slots of this store. Throws InputError for
    // one that cannot be drawn: indices out of range, numbers that are not finite. O(data) for meshes.
    MeshHandle add(Mesh mesh);
    MaterialHandle add(Material material);
    TextureHandle add(Texture texture);
    ImageHandle add(Image image);
    // A loaded scene and all that is in it. The same source with the same content is shared, as it is now
    // with its edits: O(data) to compare. The second form takes the assets out of `scene`.
    SceneHandle add(const SceneData& scene);
    SceneHandle add(SceneData&& scene);
    // The file of that name that was added last; a null handle if there is none. O(files).
    SceneHandle find_scene(std::string_view source) const;

    // Looking. All throw InputError, one line, for a handle of what has been released or never was. O(1).
    const Mesh& get(MeshHandle mesh) const;
    const Material& get(MaterialHandle material) const;
    const Texture& get(TextureHandle texture) const;
    const Image& get(ImageHandle image) const;
    const SceneAsset& get(SceneHandle scene) const;
    MaterialHandle material_of(MeshHandle mesh) const;
    TextureHandle texture_handle(const TextureRef& reference) const;  // null: it has none
    ImageHandle image_of(TextureHandle texture) const;
    bool alive(MeshHandle mesh) const { return assets().meshes.find(mesh) != nullptr; }
    bool alive(MaterialHandle material) const { return assets().materials.find(material) != nullptr; }
    bool alive(TextureHandle texture) const { return assets().textures.find(texture) != nullptr; }
    bool alive(ImageHandle image) const { return assets().images.find(image) != nullptr; }
    bool alive(SceneHandle scene) const;

    // Editing: `alter` gets a copy, which takes the asset's place under the same handle, of another version
    // in what differs. Throws like add(), and then nothing has changed. O(data) of the asset; the bounds of a
    // mesh are found anew.
    void edit_mesh(MeshHandle mesh, const std::function<void(Mesh&)>& alter);
    void edit_material(MaterialHandle material, const std::function<void(Material&)>& alter);
    void edit_texture(TextureHandle texture, const std::function<void(Texture&)>& alter);
    void edit_image(ImageHandle image, const std::function<void(Image&)>& alter);

    // Holding by hand, beside entities: each retain() wants a release(). Throw like get().
    void retain(MeshHandle mesh);
    void retain(MaterialHandle material);
    void retain(SceneHandle scene);
    void release(MeshHandle mesh);
    void release(MaterialHandle material);
    void release(SceneHandle scene);
    // How many refer to it.
    std::size_t references(MeshHandle mesh) const;
    std::size_t references(MaterialHandle material) const;
    std::size_t references(TextureHandle texture) const;
    std::size_t references(ImageHandle image) const;
    std::size_t references(SceneHandle scene) const;
    // Releases what nobody has referred to yet. O(assets).
    void discard();

    // As the assets are now. Taken once for all that ask until something changes: O(slots) then, O(1) else.
    std::shared_ptr<const SceneAssets> snapshot() const;
    // The same to look at, valid until the next change.
    const SceneAssets& assets() const;

    struct State;

  private:
    friend AssetStore& asset_store(ecs::World& world);
    std::shared_ptr<State> state_;
};

// The world's store, a resource; made when first asked for, and then the world's entities count.
AssetStore& asset_store(ecs::World& world);

}  // namespace lanthorn
