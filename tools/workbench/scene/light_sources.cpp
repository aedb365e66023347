#include "tools/workbench/scene/light_sources.h"

#include <algorithm>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/asset_store.h"

namespace lanthorn::workbench {

namespace {

std::vector<MaterialHandle> emissive_materials(ecs::World& world, ecs::Entity entity) {
    std::vector<MaterialHandle> materials;
    if (const auto* instances = world.try_get<MeshInstances>(entity)) {
        const AssetStore& store = asset_store(world);
        for (const MeshHandle mesh : instances->meshes) {
            const MaterialHandle material = store.material_of(mesh);
            if (store.get(material).emits()) {
                materials.push_back(material);
            }
        }
    }
    return materials;
}

}  // namespace

std::vector<ecs::Entity> punctual_lights(ecs::World& world) {
    return world.query<ecs::With<LightComponent>>().entities();
}

std::vector<ecs::Entity> emissive_meshes(ecs::World& world) {
    std::vector<ecs::Entity> found = world.query<ecs::With<MeshInstances>>().entities();
    std::erase_if(found, [&](ecs::Entity e) { return emissive_materials(world, e).empty(); });
    return found;
}

void DimmedLights::add(ecs::Entity entity) {
    if (const auto* light = world_->try_get<LightComponent>(entity)) {
        lights_.push_back({entity, light->light.intensity});
    }
    for (const MaterialHandle material : emissive_materials(*world_, entity)) {
        if (std::ranges::find(materials_, material, &Glow::material) == materials_.end()) {
            materials_.push_back({material, asset_store(*world_).get(material).emissive});
        }
    }
}

void DimmedLights::dim(float factor) {
    for (const Lamp& lamp : lights_) {
        world_->get_mut<LightComponent>(lamp.entity).light.intensity = factor * lamp.intensity;
    }
    for (const Glow& glow : materials_) {
        asset_store(*world_).edit_material(glow.material,
                                           [&](Material& m) { m.emissive = factor * glow.emissive; });
    }
}

}  // namespace lanthorn::workbench
