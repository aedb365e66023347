// How nodes of a model become entities.
#include <algorithm>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/extras.h"
#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/edit_world.h"

namespace lanthorn::editor {

namespace {

// Has the entity the value, or, where there is none, no T.
template <class T>
void put(ecs::World& world, ecs::Entity e, bool has, T value) {
    if (has) {
        world.insert(e, std::move(value));
    } else if (world.has<T>(e)) {
        world.remove<T>(e);
    }
}

}  // namespace

ecs::EntityNames EditWorld::names() const {
    std::vector<ecs::Entity> all;
    for (const ecs::Entity e : entities()) {
        if (e != ecs::kNullEntity) {
            all.push_back(e);
        }
    }
    return names_of(std::as_const(app_).world(), all);
}

void EditWorld::put_extras(ecs::Entity e, const std::string& extras, const ecs::EntityNames& names) {
    ecs::World& world = app_.world();
    if (const Extras* old = world.try_get<Extras>(e)) {
        for (const ecs::ComponentType* type : ecs::read_extras(app_.registry(), old->json).types) {
            if (ecs::get(world, e, *type) != nullptr) {
                type->remove(world, e);
            }
        }
    }
    put(world, e, !extras.empty(), Extras{extras});
    if (!extras.empty()) {
        const ecs::ExtrasReading reading = ecs::read_extras(app_.registry(), extras, names);
        for (std::size_t i = 0; i < reading.types.size(); ++i) {
            reading.types[i]->insert(world, e, reading.values[i].get());
        }
    }
}

// All but the place in the tree, the skin, and what other nodes must be there for.
void EditWorld::put_node(ecs::Entity e, std::uint32_t index) {
    ecs::World& world = app_.world();
    const ModelNode& node = model_.node(index);
    const bool is_shown = model_.is_shown(index);
    const SceneAsset& scene = asset();
    put(world, e, !node.name.empty(), Name{node.name});
    const LocalTransform* local = world.try_get<LocalTransform>(e);
    if (local == nullptr || local->value != node.local) {
        world.insert(e, LocalTransform{node.local});
    }
    put(world, e, node.shear != mat3(1), Shear{node.shear});
    MeshInstances meshes;
    if (node.loaded != kNone && is_shown && node.mesh != kNone) {
        for (const std::uint32_t mesh : scene.nodes[node.loaded].meshes) {
            meshes.meshes.push_back(scene.meshes.at(mesh));
        }
    }
    const MeshInstances* shown = world.try_get<MeshInstances>(e);
    if (shown == nullptr || !(*shown == meshes)) {
        const bool has = !meshes.meshes.empty();
        put(world, e, has, std::move(meshes));
    }
    const bool has_weights = node.loaded != kNone && is_shown && !scene.weights[node.loaded].empty();
    if (has_weights != world.has<MorphWeights>(e)) {
        put(world, e, has_weights, has_weights ? MorphWeights{scene.weights[node.loaded]} : MorphWeights{});
    }
    const bool has_camera = node.camera < model_.cameras.size() && model_.cameras[node.camera] != nullptr;
    put(world, e, has_camera, has_camera ? CameraComponent{*model_.cameras[node.camera]} : CameraComponent{});
    const Light* light = is_shown ? light_of(model_, index) : nullptr;
    const LightComponent* lit = world.try_get<LightComponent>(e);
    if (light == nullptr || lit == nullptr || !(lit->light == *light)) {
        put(world, e, light != nullptr, light != nullptr ? LightComponent{*light} : LightComponent{});
    }
    const Extras* extras = world.try_get<Extras>(e);
    if ((extras == nullptr ? std::string() : extras->json) != node.extras) {
        put_extras(e, node.extras, names());
    }
}

ecs::Entity EditWorld::spawn_loaded(std::uint32_t loaded, ecs::Entity parent) {
    ecs::World& world = app_.world();
    const SceneAsset& scene = asset();
    const NodeData& node = scene.nodes[loaded];
    const ecs::Entity e = world.create(LocalTransform{node.local}, WorldTransform{}, Source{scene_, loaded},
                                       EditedNode{kNone, loaded, false});
    put(world, e, !node.name.empty(), Name{node.name});
    if (parent != ecs::kNullEntity) {
        world.add(e, Parent{parent});
    }
    if (!node.meshes.empty()) {
        MeshInstances meshes;
        for (const std::uint32_t mesh : node.meshes) {
            meshes.meshes.push_back(scene.meshes.at(mesh));
        }
        world.add(e, std::move(meshes));
    }
    if (node.light != kNone) {
        world.add(e, LightComponent{scene.lights.at(node.light)});
    }
    if (node.sky != kNone) {
        world.add(e, SkyComponent{scene.skies.at(node.sky)});
    }
    if (!scene.weights[loaded].empty()) {
        world.add(e, MorphWeights{scene.weights[loaded]});
    }
    if (loaded < made_below_.size()) {
        for (const std::uint32_t below : made_below_[loaded]) {
            spawn_loaded(below, e);
        }
    }
    return e;
}

ecs::Entity EditWorld::spawn_node(std::uint32_t index, ecs::Entity parent) {
    ecs::World& world = app_.world();
    const ModelNode& node = model_.node(index);
    const ecs::Entity e =
        world.create(LocalTransform{node.local}, WorldTransform{}, EditedNode{index, node.loaded, false});
    if (node.loaded != kNone) {
        world.add(e, Source{scene_, node.loaded});
    }
    if (parent != ecs::kNullEntity) {
        world.add(e, Parent{parent});
    }
    if (is_instanced(node.loaded) &&
        model_.is_shown(index)) {  // where the importer puts them: before what stands under the node
        for (const std::uint32_t below : made_below_[node.loaded]) {
            spawn_loaded(below, e);
        }
    }
    return e;
}

void EditWorld::spawn_guests() {
    ecs::World& world = app_.world();
    for (const Guest& guest : guests_) {
        const ecs::Entity e = world.create(LocalTransform{guest.node.local}, WorldTransform{},
                                           EditedNode{kNone, kNone, true}, Name{guest.node.name});
        if (guest.node.light != kNone) {
            world.add(e, LightComponent{guest.light});
        }
        if (guest.node.sky != kNone) {
            world.add(e, SkyComponent{guest.sky});
        }
    }
}

void EditWorld::spawn_all() {
    if (!scene_) {
        return;
    }
    std::vector<ecs::Entity> by_node(model_.nodes.size(), ecs::kNullEntity);
    const std::vector<std::uint32_t> order = model_.in_order();
    for (const std::uint32_t node : order) {
        const std::uint32_t parent = model_.node(node).parent;
        by_node[node] = spawn_node(node, parent == kNone ? ecs::kNullEntity : by_node[parent]);
    }
    for (const std::uint32_t loaded : made_roots_) {
        spawn_loaded(loaded, ecs::kNullEntity);
    }
    spawn_guests();
    ecs::World& world = app_.world();
    for (const std::uint32_t node : order) {  // names first: extras refer to them
        if (!model_.node(node).name.empty()) {
            world.insert(by_node[node], Name{model_.node(node).name});
        }
    }
    const ecs::EntityNames all = names();
    for (const std::uint32_t node : order) {
        if (!model_.node(node).extras.empty()) {
            put_extras(by_node[node], model_.node(node).extras, all);
        }
        put_node(by_node[node], node);
    }
    put_skins();
    put_clips();
}

// A copy of a node has what that was loaded from, but skins and clips of the file mean the node itself: the
// one that came first into the document, wherever either stands now.
std::vector<ecs::Entity> EditWorld::by_loaded() const {
    const ecs::World& world = app_.world();
    std::vector<ecs::Entity> result(asset().nodes.size(), ecs::kNullEntity);
    const auto age = [&](ecs::Entity e) { return std::pair(world.get<EditedNode>(e).node, e.index); };
    for (const ecs::Entity e : world.query<ecs::With<EditedNode>>().entities()) {
        const std::uint32_t loaded = world.get<EditedNode>(e).loaded;
        if (loaded < result.size() && (result[loaded] == ecs::kNullEntity || age(e) < age(result[loaded]))) {
            result[loaded] = e;
        }
    }
    return result;
}

void EditWorld::put_skins() {
    const SceneAsset& scene = asset();
    if (scene.skins.empty()) {
        return;
    }
    ecs::World& world = app_.world();
    const std::vector<ecs::Entity> by_loaded = this->by_loaded();
    for (const ecs::Entity e : world.query<ecs::With<EditedNode>>().entities()) {
        const std::uint32_t loaded = world.get<EditedNode>(e).loaded;
        const std::uint32_t skin = loaded < scene.nodes.size() ? scene.nodes[loaded].skin : kNone;
        if (skin == kNone) {
            continue;
        }
        const bool is_drawn = world.has<MeshInstances>(e);
        if (is_drawn == world.has<SkinInstance>(e)) {
            continue;
        }
        SkinInstance instance;
        for (const std::uint32_t joint : scene.skins[skin].joints) {
            instance.joints.push_back(by_loaded.at(joint));
        }
        instance.inverse_binds = scene.skins[skin].inverse_binds;
        put(world, e, is_drawn, std::move(instance));
    }
}

// The clips are on the first root, as after spawn(); which root has them matters to nobody else.
void EditWorld::put_clips() {
    const SceneAsset& scene = asset();
    if (!scene.clips) {
        return;
    }
    ecs::World& world = app_.world();
    ecs::Entity first = ecs::kNullEntity;
    for (const ecs::Entity e : world.query<ecs::With<EditedNode>>().entities()) {
        const bool is_root = !world.has<Parent>(e);
        if (is_root && (first == ecs::kNullEntity || e.index < first.index)) {
            first = e;
        }
    }
    if (first == ecs::kNullEntity) {
        return;
    }
    world.add(first, AnimationSet{scene.clips, by_loaded()});
    play_wanted();
}

void EditWorld::play_wanted() {
    ecs::World& world = app_.world();
    const std::string asked = clip_.value_or(animation_);
    playing_ = asked.empty() ? named_clip(world) : asked;
    for (const ecs::Entity e : world.query<ecs::With<AnimationPlayer>>().entities()) {
        world.remove<AnimationPlayer>(e);
    }
    try {
        play_clip(world, asked, source_);
    } catch (const InputError&) {
        if (!asked.empty()) {
            throw;
        }
        // What the file names is none of its clips: nothing plays, and a warning says so.
    }
}

void EditWorld::show_moment(const std::optional<std::string>& clip, double seconds) {
    ecs::World& world = app_.world();
    world.resource_mut<SimulatedPose>().restore(SimulatedPose::Poses(world));
    world.resource_mut<Time>().moment = std::max(0.0, seconds);
    if (clip == clip_) {
        return;
    }
    const std::optional<std::string> before = std::exchange(clip_, clip);
    try {
        play_wanted();
    } catch (const InputError&) {
        clip_ = before;
        play_wanted();
        throw;
    }
}

}  // namespace lanthorn::editor
