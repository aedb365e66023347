// The hooks of components that refer to assets.
#include "lanthorn/scene/components.h"

#include <string>

#include "engine/scene/described.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/asset_store.h"

namespace lanthorn {
namespace {

using ecs::Entity;

// Throws unless the world's store has the asset, and `held`, if it is a copy's, is of that store.
template <class T>
void check_handle(const ecs::World& world, Entity e, const char* component, AssetHandle<T> asset,
                  const AssetHold<T>* held) {
    const AssetStore* store = world.try_resource<AssetStore>();
    const auto refuse = [&](const std::string& why) {
        throw InputError(std::string(component) + " of " + (e ? described(world, e) : "a new entity") + ": " +
                         why);
    };
    if (store == nullptr) {
        refuse("the world has no AssetStore, expected a handle of its assets");
    }
    if (held != nullptr && *held && held->asset() == asset && !store->holds(*held)) {
        refuse("a handle of another world's AssetStore, expected one of this world's");
    }
    try {
        store->get(asset);
    } catch (const InputError& error) {
        refuse(error.what());
    }
}

// The store without counting as a write of the resource: what is in it stays as it is.
const AssetStore& store_of(const ecs::World& world) {
    return world.resource<AssetStore>();
}

}  // namespace
}  // namespace lanthorn

namespace lanthorn::ecs {

void Hooks<MeshInstances>::check(const World& world, Entity e, const MeshInstances& value) {
    for (std::size_t i = 0; i < value.meshes.size(); ++i) {
        check_handle(world, e, "mesh_instances", value.meshes[i],
                     i < value.held.size() ? &value.held[i] : nullptr);
    }
}

void Hooks<MeshInstances>::on_add(World& world, Entity e) {
    MeshInstances& value = world.get_mut<MeshInstances>(e);
    std::vector<AssetHold<Mesh>> held;
    held.reserve(value.meshes.size());
    for (const MeshHandle mesh : value.meshes) {
        held.push_back(store_of(world).hold(mesh));
    }
    value.held = std::move(held);
}

void Hooks<Source>::check(const World& world, Entity e, const Source& value) {
    if (value.scene) {
        check_handle(world, e, "source", value.scene, &value.held);
    }
}

void Hooks<Source>::on_add(World& world, Entity e) {
    Source& value = world.get_mut<Source>(e);
    value.held = value.scene ? store_of(world).hold(value.scene) : AssetHold<SceneAsset>();
}

}  // namespace lanthorn::ecs
