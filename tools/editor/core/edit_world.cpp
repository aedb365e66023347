#include "tools/editor/core/edit_world.h"

#include <algorithm>
#include <span>
#include <utility>

#include "lanthorn/ecs/query.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::editor {

namespace {

void declare_edited_node(ecs::Registry& registry) {
    using ecs::field;
    registry
        .component<EditedNode>("edited_node", "which node of the document it shows",
                               field("node", &EditedNode::node), field("loaded", &EditedNode::loaded),
                               field("guest", &EditedNode::guest))
        .runtime()
        .transient()
        .not_in_extras();
}

template <class T>
std::uint64_t hash_of(const std::vector<T>& values) {
    return replay::hash_bytes(std::as_bytes(std::span(values)));
}

// What makes two meshes the same to a user: where their corners are, and which belong together.
std::uint64_t content_hash(const Mesh& mesh) {
    std::vector<vec3> corners;
    for (const Vertex& vertex : mesh.vertices) {
        corners.push_back(vertex.position);
    }
    return hash_of(corners) * 31 + hash_of(mesh.indices);
}

std::vector<std::uint64_t> mesh_hashes(const SceneData& scene) {
    std::vector<std::uint64_t> hashes;
    for (std::size_t i = 0; i < scene.meshes.size() && i < scene.file.meshes.size(); ++i) {
        const std::uint32_t mesh = scene.file.meshes[i].mesh;
        if (mesh == kNone) {
            continue;
        }
        if (mesh >= hashes.size()) {
            hashes.resize(mesh + 1, 0);
        }
        hashes[mesh] = hashes[mesh] * 0x9e3779b97f4a7c15u + content_hash(scene.meshes[i]);
        hashes[mesh] += hashes[mesh] == 0 ? 1 : 0;
    }
    return hashes;
}

bool same_structure(const EditModel& a, const EditModel& b) {
    if (a.roots != b.roots) {
        return false;
    }
    const std::size_t most = std::max(a.nodes.size(), b.nodes.size());
    for (std::uint32_t i = 0; i < most; ++i) {
        const ModelNode* x = a.find(i);
        const ModelNode* y = b.find(i);
        if (x != y &&
            (x == nullptr || y == nullptr || x->parent != y->parent || x->children != y->children)) {
            return false;
        }
    }
    return true;
}

// A node whose meshes the importer has put into nodes of their own is hidden or shown.
bool hides_or_shows(const EditModel& a, const EditModel& b, std::uint32_t node) {
    return a.find(node) != b.find(node) && a.node(node).visible != b.node(node).visible;
}

}  // namespace

EditWorld::EditWorld(App& app) : app_(app) {
    declare_edited_node(app.registry());
}

void EditWorld::load(SceneData scene, std::size_t own, EditModel& model, const workbench::SceneView& view) {
    std::vector<std::uint32_t> made_roots;
    std::vector<std::vector<std::uint32_t>> made_below(own);
    for (std::uint32_t i = 0; i < own; ++i) {
        if (scene.file.nodes.at(i) == kNone) {
            const std::uint32_t parent = scene.nodes[i].parent;
            (parent == kNone ? made_roots : made_below[parent]).push_back(i);
        }
    }
    std::vector<std::uint64_t> hashes = mesh_hashes(scene);
    take_guests(scene, own);
    scene.nodes.resize(own);  // what is lent is no part of the file
    // A store of its own: in that of the scene before, materials may be as they were edited, and what draws
    // in the order of slots would draw in another than the game.
    AssetStore fresh;
    std::string source = scene.source;
    const SceneHandle handle = fresh.add(std::move(scene));
    AssetHold<SceneAsset> hold = fresh.hold(handle);
    destroy_all();
    source_ = std::move(source);
    scene_ = handle;
    held_ = std::move(hold);
    AssetStore& store = asset_store(app_.world());
    store = std::move(fresh);
    animation_ = view.animation;
    clip_.reset();
    playing_.clear();
    app_.world().resource_mut<Time>().moment = 0;
    made_roots_ = std::move(made_roots);
    made_below_ = std::move(made_below);
    mesh_hashes_ = std::move(hashes);
    for (std::uint32_t i = 0; i < model.materials.size(); ++i) {
        if (const MaterialHandle material = this->material(i)) {
            model.materials[i] = std::make_shared<const Material>(store.get(material));
        }
    }
    model_ = model;
    spawn_all();
}

void EditWorld::take_guests(const SceneData& scene, std::size_t own) {
    guests_.clear();
    for (std::size_t i = own; i < scene.nodes.size(); ++i) {
        const NodeData& node = scene.nodes[i];
        Guest guest{node, {}, {}};
        if (node.light != kNone) {
            guest.light = scene.lights.at(node.light);
        }
        if (node.sky != kNone) {
            guest.sky = scene.skies.at(node.sky);
        }
        guests_.push_back(std::move(guest));
    }
}

void EditWorld::lend(const SceneData& scene, std::size_t own) {
    take_guests(scene, own);
    std::vector<ecs::Entity> old = guests();
    std::ranges::sort(old, [](ecs::Entity a, ecs::Entity b) { return a.index > b.index; });
    for (const ecs::Entity e : old) {
        app_.world().destroy(e);
    }
    spawn_guests();
}

void EditWorld::destroy_all() {
    ecs::World& world = app_.world();
    std::vector<ecs::Entity> all = world.query<ecs::With<EditedNode>>().entities();
    // The last first: numbers that become free are given again last freed first, so that new ones ascend.
    std::ranges::sort(all, [](ecs::Entity a, ecs::Entity b) { return a.index > b.index; });
    for (const ecs::Entity e : all) {
        if (world.alive(e)) {
            world.destroy(e);
        }
    }
}

void EditWorld::show(const EditModel& model) {
    const EditModel before = std::exchange(model_, model);
    AssetStore& store = asset_store(app_.world());
    for (std::uint32_t i = 0; i < model.materials.size(); ++i) {
        if (i < before.materials.size() && before.materials[i] != model.materials[i]) {
            const Material& now = *model.materials[i];
            store.edit_material(material(i), [&](Material& altered) { altered = now; });
        }
    }
    if (same_structure(before, model) && !alters_instances(before)) {
        put_values(before);
        ecs::World& world = app_.world();
        if (!clip_ && animation_.empty() && named_clip(world) != playing_) {
            world.resource_mut<SimulatedPose>().restore(SimulatedPose::Poses(world));
            play_wanted();
        }
        return;
    }
    destroy_all();
    spawn_all();
}

bool EditWorld::alters_instances(const EditModel& before) const {
    const bool has_instances =
        std::ranges::any_of(made_below_, [](const auto& list) { return !list.empty(); });
    for (std::uint32_t i = 0; has_instances && i < model_.nodes.size(); ++i) {
        if (model_.find(i) != nullptr && hides_or_shows(before, model_, i)) {
            return true;
        }
    }
    return false;
}

void EditWorld::put_values(const EditModel& before) {
    std::vector<std::uint32_t> altered;
    const auto differs = [](const auto& a, const auto& b, std::uint32_t i) {
        return i < b.size() && (i >= a.size() || a[i] != b[i]);
    };
    std::vector<std::uint32_t> pending;
    for (std::uint32_t i = 0; i < model_.nodes.size(); ++i) {
        const ModelNode* now = model_.find(i);
        const ModelNode* old = before.find(i);
        if (now == nullptr) {
            continue;
        }
        if (now != old) {
            altered.push_back(i);
            if (now->visible != old->visible) {
                pending.insert(pending.end(), now->children.begin(), now->children.end());
            }
        } else if (differs(before.lights, model_.lights, now->light) ||
                   differs(before.cameras, model_.cameras, now->camera)) {
            altered.push_back(i);
        }
    }
    while (!pending.empty()) {  // what stands under a node that is hidden or shown
        const std::uint32_t next = pending.back();
        pending.pop_back();
        altered.push_back(next);
        const auto& children = model_.node(next).children;
        pending.insert(pending.end(), children.begin(), children.end());
    }
    if (altered.empty()) {
        return;
    }
    const std::vector<ecs::Entity> by_node = entities();
    for (const std::uint32_t node : altered) {
        put_node(by_node.at(node), node);
    }
    put_skins();
}

ecs::Entity EditWorld::entity_of(std::uint32_t node) const {
    ecs::Entity found = ecs::kNullEntity;
    std::as_const(app_).world().query<ecs::Read<EditedNode>>().each(
        [&](ecs::Entity e, const EditedNode& n) { found = n.node == node && node != kNone ? e : found; });
    return found;
}

std::uint32_t EditWorld::node_of(ecs::Entity e) const {
    const EditedNode* node = std::as_const(app_).world().try_get<EditedNode>(e);
    return node != nullptr ? node->node : kNone;
}

std::vector<ecs::Entity> EditWorld::entities() const {
    std::vector<ecs::Entity> all(model_.nodes.size(), ecs::kNullEntity);
    std::as_const(app_).world().query<ecs::Read<EditedNode>>().each([&](ecs::Entity e, const EditedNode& n) {
        if (n.node < all.size()) {
            all[n.node] = e;
        }
    });
    return all;
}

std::vector<ecs::Entity> EditWorld::guests() const {
    std::vector<ecs::Entity> all;
    std::as_const(app_).world().query<ecs::Read<EditedNode>>().each([&](ecs::Entity e, const EditedNode& n) {
        if (n.guest) {
            all.push_back(e);
        }
    });
    return all;
}

const SceneAsset& EditWorld::asset() const {
    return std::as_const(app_).world().resource<AssetStore>().get(scene_);
}

MaterialHandle EditWorld::material(std::uint32_t index) const {
    return scene_ ? material_at(asset(), index) : MaterialHandle();
}

std::uint64_t EditWorld::mesh_hash(std::uint32_t mesh) const {
    return mesh < mesh_hashes_.size() ? mesh_hashes_[mesh] : 0;
}

bool EditWorld::has_sky() const {
    return scene_ && std::ranges::any_of(asset().nodes, [](const NodeData& n) { return n.sky != kNone; });
}

bool EditWorld::is_instanced(std::uint32_t loaded) const {
    return loaded < made_below_.size() && !made_below_[loaded].empty();
}

}  // namespace lanthorn::editor
