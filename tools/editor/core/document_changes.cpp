#include "tools/editor/core/document_changes.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"

namespace lanthorn::editor {

namespace {

using Json = nlohmann::json;

const ModelNode& nothing() {
    static const ModelNode node;
    return node;
}

// Members that other programs keep there stay as text.
void write_extras(GltfDocument& document, std::uint32_t node, const std::string& before,
                  const std::string& after) {
    if (before == after) {
        return;
    }
    const Json old = before.empty() ? Json::object() : parse_json(before, "extras");
    const Json now = after.empty() ? Json::object() : parse_json(after, "extras");
    if (!old.is_object() || !now.is_object()) {
        document.set_extras(node, after);
        return;
    }
    for (const auto& [key, value] : now.items()) {
        if (!old.contains(key) || old[key] != value) {
            document.set_extra(node, key, value.dump());
        }
    }
    for (const auto& [key, value] : old.items()) {
        if (!now.contains(key)) {
            document.remove_extra(node, key);
        }
    }
}

void write_node(GltfDocument& document, std::uint32_t index, const ModelNode& before,
                const ModelNode& after) {
    if (before.name != after.name) {
        document.set_node_name(index, after.name);
    }
    if (before.local != after.local || before.shear != after.shear) {
        document.set_transform(index, after.local, after.shear);
    }
    write_extras(document, index, before.extras, after.extras);
    if (before.mesh != after.mesh) {
        document.set_node_mesh(index, after.mesh);
    }
    if (before.skin != after.skin) {
        document.set_node_skin(index, after.skin);
    }
    if (before.camera != after.camera) {
        document.set_node_camera(index, after.camera);
    }
    if (before.light != after.light) {
        document.set_node_light(index, after.light);
    }
    if (before.visible != after.visible) {
        document.set_node_visible(index, after.visible);
    }
}

// Who stands under `parent`, in the order of `after`. Those up to the first that differs are left alone.
void write_order(GltfDocument& document, std::uint32_t parent, const EditModel& before,
                 const EditModel& after) {
    const std::vector<std::uint32_t>& wanted = after.children_of(parent);
    std::vector<std::uint32_t> there;
    if (parent == kNone || before.find(parent) != nullptr) {
        there = before.children_of(parent);
    }
    std::erase_if(there, [&](std::uint32_t child) {
        const ModelNode* node = after.find(child);
        return node == nullptr || node->parent != parent;
    });
    for (std::uint32_t i = static_cast<std::uint32_t>(before.nodes.size()); i < after.nodes.size(); ++i) {
        if (after.nodes[i] != nullptr && after.nodes[i]->parent == parent) {
            there.push_back(i);  // add_node() has put it there
        }
    }
    const auto differs = std::ranges::mismatch(wanted, there).in1;
    for (auto at = differs; at != wanted.end(); ++at) {
        document.set_parent(*at, parent);
    }
}

template <class T, class Write>
void write_each(const std::vector<std::shared_ptr<const T>>& before,
                const std::vector<std::shared_ptr<const T>>& after, const Write& write) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != after[i] && after[i] != nullptr) {
            write(i, *after[i]);
        }
    }
}

}  // namespace

void write_changes(GltfDocument& document, const EditModel& before, const EditModel& after) {
    for (std::size_t i = before.lights.size(); i < after.lights.size(); ++i) {
        [[maybe_unused]] const std::size_t index = document.add_light(*after.lights[i]);
        assert(index == i);
    }
    const std::size_t nodes = before.nodes.size();
    for (std::size_t i = nodes; i < after.nodes.size(); ++i) {
        const ModelNode& node = after.nodes[i] != nullptr ? *after.nodes[i] : nothing();
        [[maybe_unused]] const std::size_t index = document.add_node(node.name, node.parent);
        assert(index == i);
        if (after.nodes[i] == nullptr) {
            document.remove_node(i);
            continue;
        }
        ModelNode bare;
        bare.name = node.name;
        write_node(document, static_cast<std::uint32_t>(i), bare, node);
    }
    std::vector<std::uint32_t> parents;  // whose children are others
    if (before.roots != after.roots) {
        parents.push_back(kNone);
    }
    for (std::uint32_t i = 0; i < after.nodes.size(); ++i) {
        const ModelNode* old = before.find(i);
        const ModelNode* now = after.find(i);
        if (old == now) {
            continue;
        }
        if (old != nullptr && now == nullptr) {
            const bool goes_with_parent = old->parent != kNone && after.find(old->parent) == nullptr;
            if (!goes_with_parent) {
                document.remove_node(i);
            }
            continue;
        }
        if (old != nullptr) {
            write_node(document, i, *old, *now);
        }
        if (old == nullptr ? !now->children.empty() : old->children != now->children) {
            parents.push_back(i);
        }
    }
    for (const std::uint32_t parent : parents) {
        write_order(document, parent, before, after);
    }
    write_each(before.lights, after.lights, [&](std::size_t i, const Light& l) { document.set_light(i, l); });
    write_each(before.cameras, after.cameras,
               [&](std::size_t i, const Camera& c) { document.set_camera(i, c); });
    write_each(before.materials, after.materials,
               [&](std::size_t i, const Material& m) { document.set_material(i, m); });
}

}  // namespace lanthorn::editor
