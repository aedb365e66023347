#include "lanthorn/scene/spawn.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <unordered_map>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {
namespace {

void shift(TextureRef& ref, std::uint32_t by) {
    if (ref.present()) ref.texture += by;
}

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// Joins the scene's assets to those of the world. Returns the index of the scene's first mesh.
std::uint32_t publish(ecs::World& world, SceneData& scene) {
    auto assets = std::make_shared<SceneAssets>();
    if (const SharedAssets* old = world.try_resource<SharedAssets>(); old && *old) *assets = **old;
    const auto meshes = static_cast<std::uint32_t>(assets->meshes.size());
    const auto materials = static_cast<std::uint32_t>(assets->materials.size());
    const auto textures = static_cast<std::uint32_t>(assets->textures.size());
    const auto images = static_cast<std::uint32_t>(assets->images.size());
    for (Mesh& mesh : scene.meshes) mesh.material += materials;
    for (Material& m : scene.materials) {
        for (TextureRef* ref : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                &m.occlusion_texture, &m.emissive_texture, &m.specular_texture,
                                &m.specular_colour_texture, &m.transmission_texture}) {
            shift(*ref, textures);
        }
    }
    for (Texture& texture : scene.textures) texture.image += images;
    append(assets->meshes, std::move(scene.meshes));
    append(assets->materials, std::move(scene.materials));
    append(assets->textures, std::move(scene.textures));
    append(assets->images, std::move(scene.images));
    static std::atomic<std::uint64_t> serial{0};
    assets->serial = ++serial;
    world.insert_resource(SharedAssets(std::move(assets)));
    return meshes;
}

// The weights that the node's meshes start with: its own or else those of the first mesh that has any, one
// for each target of the mesh with most.
std::vector<float> start_weights(const NodeData& node, const std::vector<Mesh>& meshes) {
    std::vector<float> weights = node.morph_weights;
    std::size_t targets = 0;
    for (const std::uint32_t index : node.meshes) {
        const Mesh& mesh = meshes.at(index);
        targets = std::max(targets, mesh.morphs.size());
        if (weights.empty()) weights = mesh.morph_weights;
    }
    weights.resize(targets, 0.0f);
    return weights;
}

SkinInstance skin_instance(const Skin& skin, const std::vector<ecs::Entity>& entities) {
    SkinInstance instance;
    for (const std::uint32_t joint : skin.joints) instance.joints.push_back(entities.at(joint));
    instance.inverse_binds = skin.inverse_binds;
    return instance;
}

}  // namespace

std::vector<ecs::Entity> spawn(ecs::World& world, SceneData&& scene) {
    std::vector<std::vector<float>> weights;
    for (const NodeData& node : scene.nodes) weights.push_back(start_weights(node, scene.meshes));
    const std::uint32_t first_mesh = publish(world, scene);
    std::vector<ecs::Entity> entities;
    entities.reserve(scene.nodes.size());
    std::vector<dmat4> matrices;
    for (NodeData& node : scene.nodes) {
        dmat4 matrix = local_matrix(node.local, node.shear);
        if (node.parent != kNone) matrix = matrices.at(node.parent) * matrix;
        matrices.push_back(matrix);
        const ecs::Entity e = world.create(LocalTransform{node.local}, WorldTransform{matrix});
        entities.push_back(e);
        if (!node.name.empty()) world.add(e, Name{std::move(node.name)});
        if (node.parent != kNone) world.add(e, Parent{entities.at(node.parent)});
        if (node.shear != mat3(1)) world.add(e, Shear{node.shear});
        if (!node.meshes.empty()) {
            for (std::uint32_t& mesh : node.meshes) mesh += first_mesh;
            world.add(e, MeshInstances{std::move(node.meshes)});
        }
        if (node.camera != kNone) world.add(e, CameraComponent{scene.cameras.at(node.camera)});
        if (node.light != kNone) world.add(e, LightComponent{scene.lights.at(node.light)});
        if (!node.extras.empty()) world.add(e, Extras{std::move(node.extras)});
        if (std::vector<float>& start = weights.at(entities.size() - 1); !start.empty()) {
            world.add(e, MorphWeights{std::move(start)});
        }
    }
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::uint32_t skin = scene.nodes[i].skin;
        if (skin != kNone) world.add(entities[i], skin_instance(scene.skins.at(skin), entities));
    }
    if (!scene.animations.empty()) {
        auto clips = std::make_shared<const std::vector<AnimationClip>>(std::move(scene.animations));
        world.create(AnimationSet{std::move(clips), entities});
    }
    return entities;
}

std::vector<ecs::Entity> spawn(ecs::World& world, const SceneData& scene) {
    return spawn(world, SceneData(scene));
}

void destroy_tree(ecs::World& world, ecs::Entity root) {
    std::unordered_map<ecs::Entity, std::vector<ecs::Entity>> children;
    world.query<ecs::Read<Parent>>().each(
        [&](ecs::Entity e, const Parent& parent) { children[parent.entity].push_back(e); });
    std::vector<ecs::Entity> doomed{root};
    while (!doomed.empty()) {
        const ecs::Entity e = doomed.back();
        doomed.pop_back();
        if (const auto found = children.find(e); found != children.end()) {
            doomed.insert(doomed.end(), found->second.begin(), found->second.end());
            children.erase(found);
        }
        // A cycle leads back to what is gone already; a dead root is the caller's error.
        if (e == root || world.alive(e)) world.destroy(e);
    }
}

ecs::Entity find_by_name(ecs::World& world, std::string_view name) {
    ecs::Entity found;
    world.query<ecs::Read<Name>>().each([&](ecs::Entity e, const Name& n) {
        if (!found && n.value == name) found = e;
    });
    return found;
}

}  // namespace lanthorn
