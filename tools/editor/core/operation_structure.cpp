// Nodes that come, go, are named, hidden and put under others.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "engine/assets/json_text.h"
#include "engine/assets/matrix_parts.h"
#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

std::string valid_name(Operation& op, const std::string& name) {
    if (name.empty()) {
        op.refuse("found an empty name, expected one");
    }
    json_quoted(name);  // refuses what is not UTF-8
    return name;
}

void add_node(Operation& op) {
    op.expect_count({2, 5});
    const std::uint32_t parent = op.parent_at_word(1);
    const std::string above = path_of(op.model, parent);
    ModelNode node;
    node.name = valid_name(op, op.word_at(2));
    node.local.translation = op.count() == 5 ? op.vector_at(3) : dvec3(0);
    const dvec3 at = node.local.translation;
    const std::uint32_t index = op.add_node(std::move(node), parent);
    op.set_local(index, op.model.node(index).local, mat3(1));
    op.say({word(above), word(op.word_at(2)), number(at.x), number(at.y), number(at.z)});
    op.result.path = path_of(op.model, index);
    op.result.after = fmt::format("{{\"translation\":[{},{},{}]}}", number(at.x), number(at.y), number(at.z));
    op.result.touched = {index};
}

void add_light(Operation& op) {
    op.expect_count({6, 7, 8});
    const std::uint32_t parent = op.parent_at_word(1);
    const std::string above = path_of(op.model, parent);
    const std::string type = op.word_at(3);
    Light light;
    if (type == "spot" || type == "directional") {
        light.type = type == "spot" ? LightType::spot : LightType::directional;
    } else if (type != "point") {
        op.refuse(fmt::format("found '{}', expected point, spot or directional", type));
    }
    const bool is_far = light.type == LightType::directional;
    light.intensity = is_far ? 10000.0f : 80.0f;
    light.colour = is_far ? vec3(1) : colour_of_kelvin(3000);
    light.colour /= std::max({light.colour.x, light.colour.y, light.colour.z});
    ModelNode node;
    node.name = valid_name(op, op.word_at(2));
    const dvec3 at = op.vector_at(4);
    node.local.translation = at;
    node.light = op.add_light(light);
    const std::uint32_t index = op.add_node(std::move(node), parent);
    op.set_local(index, op.model.node(index).local, mat3(1));
    if (op.count() >= 8) {
        apply_light_value(op, index, "colour", op.word_at(8));
    }
    if (op.count() >= 7) {
        apply_light_value(op, index, "intensity", op.word_at(7));
    }
    const Light& now = *light_of(op.model, index);
    op.say({word(above), word(op.word_at(2)), type, number(at.x), number(at.y), number(at.z),
            number(now.intensity),
            fmt::format("[{},{},{}]", number(now.colour.x), number(now.colour.y), number(now.colour.z))});
    op.result.path = path_of(op.model, index);
    op.result.before.clear();
    op.result.after = fmt::format("{{\"light\":\"{}\",\"intensity\":{}}}", type, number(now.intensity));
    op.result.touched = {index};
}

void duplicate(Operation& op) {
    op.expect_count({1, 2});
    const std::uint32_t root = op.node_at_word(1);
    const std::string path = path_of(op.model, root);
    const std::uint32_t parent = op.model.node(root).parent;
    const std::string wanted =
        op.count() == 2 ? valid_name(op, op.word_at(2)) : op.unique_name(called(op.model, root), parent);
    std::map<std::uint32_t, std::uint32_t> copies;
    std::vector<std::uint32_t> pending{root};
    for (std::size_t i = 0; i < pending.size(); ++i) {  // parents first, siblings in their order
        const std::uint32_t from = pending[i];
        ModelNode node = op.model.node(from);
        pending.insert(pending.end(), node.children.begin(), node.children.end());
        node.children.clear();
        if (from == root) {
            node.name = wanted;
        }
        if (const Light* light = light_of(op.model, from)) {
            node.light = op.add_light(Light(*light));  // of its own, to be altered apart
        }
        const std::uint32_t above = from == root ? parent : copies.at(op.model.node(from).parent);
        copies[from] = op.add_node(std::move(node), above);
    }
    op.say({word(path), word(wanted)});
    op.result.path = path_of(op.model, copies.at(root));
    op.result.after = fmt::format("{{\"nodes\":{}}}", copies.size());
    op.result.touched = {copies.at(root)};
}

// A skin without one of its joints is none: the importer would show the mesh unposed.
void expect_no_joints_gone(Operation& op, const std::vector<std::uint32_t>& gone) {
    for (std::uint32_t i = 0; i < op.model.nodes.size(); ++i) {
        const ModelNode* node = op.model.find(i);
        if (node == nullptr || op.model.joints == nullptr || node->skin >= op.model.joints->size()) {
            continue;
        }
        for (const std::uint32_t joint : (*op.model.joints)[node->skin]) {
            if (std::ranges::find(gone, joint) != gone.end()) {
                op.refuse(fmt::format("a joint of '{}' would go, expected that node to go first",
                                      path_of(op.model, i)));
            }
        }
    }
}

void remove(Operation& op) {
    op.expect_count({1});
    const std::uint32_t root = op.node_at_word(1);
    const std::string path = path_of(op.model, root);
    op.detach(root);
    std::vector<std::uint32_t> pending{root};
    for (std::size_t i = 0; i < pending.size(); ++i) {
        const auto& children = op.model.node(pending[i]).children;
        pending.insert(pending.end(), children.begin(), children.end());
    }
    for (const std::uint32_t node : pending) {
        op.model.nodes[node] = nullptr;
    }
    expect_no_joints_gone(op, pending);
    op.say({word(path)});
    op.result.path = path;
    op.result.before = fmt::format("{{\"nodes\":{}}}", pending.size());
}

void rename(Operation& op) {
    op.expect_count({2});
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    const std::string name = valid_name(op, op.word_at(2));
    op.result.before = json_quoted(op.model.node(node).name);
    op.result.after = json_quoted(name);
    op.model.alter(node).name = name;
    op.say({word(path), word(name)});
    op.result.path = path;
    op.result.touched = {node};
}

void put_under(Operation& op, std::uint32_t node, std::uint32_t parent) {
    if (parent != kNone && op.model.is_within(parent, node)) {
        op.refuse(fmt::format("'{}' stands under '{}' or is it, expected another parent",
                              path_of(op.model, parent), path_of(op.model, node)));
    }
    const dmat4 world = op.model.world_matrix(node);
    op.detach(node);
    op.attach(node, parent);
    if (parent == kNone && world == local_matrix(op.model.node(node).local, op.model.node(node).shear)) {
        return;
    }
    const dmat4 above = parent == kNone ? dmat4(1) : op.model.world_matrix(parent);
    if (!(std::abs(glm::determinant(above)) > 0)) {
        op.refuse(fmt::format("'{}' has no size, expected a parent that has", path_of(op.model, parent)));
    }
    Transform local;
    mat3 shear(1);
    decompose(glm::inverse(above) * world, local, shear);
    op.set_local(node, local, shear);
}

void reparent(Operation& op) {
    op.expect_count({2});
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    const std::uint32_t parent = op.parent_at_word(2);
    const std::string above = path_of(op.model, parent);
    op.result.before = json_quoted(path_of(op.model, op.model.node(node).parent));
    put_under(op, node, parent);
    op.result.after = json_quoted(above);
    op.say({word(path), word(above)});
    op.result.path = path;
    op.result.touched = {node};
}

void group(Operation& op) {
    if (op.count() < 2) {
        op.expect_count({2});
    }
    const std::string name = valid_name(op, op.word_at(1));
    std::vector<std::uint32_t> members;
    std::string text = op.name() + ' ' + word(name);
    for (std::size_t i = 2; i <= op.count(); ++i) {
        const std::uint32_t node = op.node_at_word(i);
        if (std::ranges::find(members, node) == members.end()) {
            members.push_back(node);
            text += ' ' + word(path_of(op.model, node));
        }
    }
    ModelNode node;
    node.name = name;
    const std::uint32_t parent = op.model.node(members.front()).parent;
    const std::uint32_t index = op.add_node(std::move(node), parent);
    for (const std::uint32_t member : members) {
        put_under(op, member, index);
    }
    op.result.text = text;
    op.result.path = path_of(op.model, index);
    op.result.after = fmt::format("{{\"nodes\":{}}}", members.size());
    op.result.touched = {index};
}

void set_visible(Operation& op, bool visible) {
    op.expect_count({1});
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    op.result.before = op.model.node(node).visible ? "true" : "false";
    op.result.after = visible ? "true" : "false";
    op.model.alter(node).visible = visible;
    op.say({word(path)});
    op.result.path = path;
    op.result.touched = {node};
}

}  // namespace

void apply_structure(Operation& op) {
    const std::string& name = op.name();
    if (name == "add-node") {
        add_node(op);
    } else if (name == "add-light") {
        add_light(op);
    } else if (name == "duplicate") {
        duplicate(op);
    } else if (name == "delete") {
        remove(op);
    } else if (name == "rename") {
        rename(op);
    } else if (name == "reparent") {
        reparent(op);
    } else if (name == "group") {
        group(op);
    } else {
        set_visible(op, name == "show");
    }
}

}  // namespace lanthorn::editor
