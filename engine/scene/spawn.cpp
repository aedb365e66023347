#include "lanthorn/scene/spawn.h"

#include <algorithm>
#include <utility>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {
namespace {

SkinInstance skin_instance(const Skin& skin, const std::vector<ecs::Entity>& entities) {
    SkinInstance instance;
    for (const std::uint32_t joint : skin.joints) instance.joints.push_back(entities.at(joint));
    instance.inverse_binds = skin.inverse_binds;
    return instance;
}

MeshInstances mesh_instances(const NodeData& node, const SceneAsset& scene) {
    MeshInstances instances;
    for (const std::uint32_t mesh : node.meshes) instances.meshes.push_back(scene.meshes.at(mesh));
    return instances;
}

// The node that has the scene's clips: the first root that is moved, or has moved nodes below it. Parents
// come before their children.
std::size_t home_of_clips(const SceneAsset& scene) {
    std::vector<std::size_t> root(scene.nodes.size());
    for (std::size_t i = 0; i < root.size(); ++i) {
        const std::uint32_t parent = scene.nodes[i].parent;
        root[i] = parent == kNone ? i : root[parent];
    }
    std::size_t first = root.size();
    for (const AnimationClip& clip : *scene.clips) {
        for (const AnimationChannel& channel : clip.channels) {
            if (channel.node < root.size()) {
                first = std::min(first, root[channel.node]);
            }
        }
        for (const PropertyChannel& channel : clip.properties) {
            for (const std::uint32_t node : channel.nodes) {
                first = node < root.size() ? std::min(first, root[node]) : first;
            }
        }
    }
    return first < root.size() ? first : 0;
}

}  // namespace

std::vector<ecs::Entity> spawn(ecs::World& world, SceneHandle handle) {
    const SceneAsset& scene = asset_store(world).get(handle);
    std::vector<ecs::Entity> entities;
    entities.reserve(scene.nodes.size());
    std::vector<dmat4> matrices;
    matrices.reserve(scene.nodes.size());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const NodeData& node = scene.nodes[i];
        dmat4 matrix = local_matrix(node.local, node.shear);
        if (node.parent != kNone) matrix = matrices.at(node.parent) * matrix;
        matrices.push_back(matrix);
        const ecs::Entity e =
            world.create(LocalTransform{node.local}, WorldTransform{matrix}, Source{handle, i});
        entities.push_back(e);
        if (!node.name.empty()) world.add(e, Name{node.name});
        if (node.parent != kNone) world.add(e, Parent{entities.at(node.parent)});
        if (node.shear != mat3(1)) world.add(e, Shear{node.shear});
        if (!node.meshes.empty()) world.add(e, mesh_instances(node, scene));
        if (node.camera != kNone) world.add(e, CameraComponent{scene.cameras.at(node.camera)});
        if (node.light != kNone) world.add(e, LightComponent{scene.lights.at(node.light)});
        if (node.sky != kNone) world.add(e, SkyComponent{scene.skies.at(node.sky)});
        if (!node.extras.empty()) world.add(e, Extras{node.extras});
        if (!scene.weights[i].empty()) world.add(e, MorphWeights{scene.weights[i]});
    }
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::uint32_t skin = scene.nodes[i].skin;
        if (skin != kNone) world.add(entities[i], skin_instance(scene.skins.at(skin), entities));
    }
    if (scene.clips && !entities.empty()) {
        world.add(entities[home_of_clips(scene)], AnimationSet{scene.clips, entities});
    }
    return entities;
}

std::vector<ecs::Entity> spawn(ecs::World& world, const SceneData& scene) {
    return spawn(world, asset_store(world).add(scene));
}

std::vector<ecs::Entity> spawn(ecs::World& world, SceneData&& scene) {
    return spawn(world, asset_store(world).add(std::move(scene)));
}

namespace {

std::uint32_t at_or_none(const std::vector<std::uint32_t>& map, std::uint32_t index) {
    return index < map.size() ? map[index] : kNone;
}

FilePlace file_place(const SceneAsset& scene, std::uint32_t index) {
    FilePlace place;
    place.source = scene.source;
    const NodeData& node = scene.nodes.at(index);
    place.node = at_or_none(scene.file.nodes, index);
    place.camera = at_or_none(scene.file.cameras, node.camera);
    place.light = at_or_none(scene.file.lights, node.light);
    for (const std::uint32_t mesh : node.meshes) {
        place.meshes.push_back(mesh < scene.file.meshes.size() ? scene.file.meshes[mesh]
                                                               : FileMap::Primitive());
    }
    return place;
}

}  // namespace

FilePlace file_place(const ecs::World& world, ecs::Entity e) {
    const Source* source = world.try_get<Source>(e);
    const AssetStore* store = world.try_resource<AssetStore>();
    return source != nullptr && store != nullptr && store->alive(source->scene)
               ? file_place(store->get(source->scene), source->node)
               : FilePlace();
}

std::vector<ecs::Entity> entities_at(ecs::World& world, SceneHandle scene, std::uint32_t FilePlace::*what,
                                     std::uint32_t index) {
    std::vector<ecs::Entity> found;
    if (index == kNone) {
        return found;
    }
    const SceneAsset& asset = asset_store(world).get(scene);
    world.query<ecs::Read<Source>>().each([&](ecs::Entity e, const Source& source) {
        if (source.scene == scene && file_place(asset, source.node).*what == index) {
            found.push_back(e);
        }
    });
    return found;
}

MaterialHandle material_at(const SceneAsset& scene, std::uint32_t index) {
    const auto found = std::ranges::find(scene.file.materials, index);
    return index != kNone && found != scene.file.materials.end()
               ? scene.materials.at(static_cast<std::size_t>(found - scene.file.materials.begin()))
               : MaterialHandle();
}

std::uint32_t file_index(const SceneAsset& scene, MaterialHandle material) {
    const auto found = std::ranges::find(scene.materials, material);
    return at_or_none(scene.file.materials, static_cast<std::uint32_t>(found - scene.materials.begin()));
}

ecs::Entity find_by_name(ecs::World& world, std::string_view name) {
    ecs::Entity found;
    world.query<ecs::Read<Name>>().each([&](ecs::Entity e, const Name& n) {
        if (!found && n.value == name) found = e;
    });
    return found;
}

}  // namespace lanthorn
