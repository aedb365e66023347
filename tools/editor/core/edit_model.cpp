#include "tools/editor/core/edit_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::editor {

namespace {

using Json = nlohmann::json;

// The number that the shortest decimal of `value` reads back as: what GltfDocument writes for it.
double written(float value) {
    char text[64];
    const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    double read = value;
    std::from_chars(std::begin(text), end, read);
    return read;
}

// A rotation as a file gives it back.
quat read_again(const quat& rotation) {
    const glm::dquat q(written(rotation.w), written(rotation.x), written(rotation.y), written(rotation.z));
    const double length = glm::length(q);
    return length > 1e-12 ? quat(q / length) : quat(1, 0, 0, 0);
}

std::uint32_t index_at(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? static_cast<std::uint32_t>(found->get<double>())
                                                       : kNone;
}

bool visibility(const Json& node) {
    static const Json::json_pointer place("/extensions/KHR_node_visibility/visible");
    return !node.contains(place) || !node[place].is_boolean() || node[place].get<bool>();
}

// In the order of the file; those that the importer has left out are not there. What is `seen` has its place.
std::vector<std::uint32_t> children_in(const Json& list, const EditModel& model, std::uint32_t parent,
                                       std::vector<bool>& seen) {
    std::vector<std::uint32_t> found;
    for (const Json& entry : list) {
        const auto child = static_cast<std::uint32_t>(entry.get<double>());
        const ModelNode* node = model.find(child);
        if (node != nullptr && node->parent == parent && !seen[child]) {
            seen[child] = true;
            found.push_back(child);
        }
    }
    return found;
}

template <class T>
void keep(std::vector<std::shared_ptr<const T>>& list, std::uint32_t index, const T& value) {
    if (index == kNone) {
        return;
    }
    if (index >= list.size()) {
        list.resize(index + 1);
    }
    list[index] = std::make_shared<const T>(value);
}

}  // namespace

const ModelNode& EditModel::node(std::uint32_t index) const {
    const ModelNode* found = find(index);
    if (found == nullptr) {
        throw InputError(fmt::format("found node {}, expected one that stands in the scene", index));
    }
    return *found;
}

ModelNode& EditModel::alter(std::uint32_t index) {
    auto copy = std::make_shared<ModelNode>(node(index));
    ModelNode& altered = *copy;
    nodes[index] = std::move(copy);
    return altered;
}

const std::vector<std::uint32_t>& EditModel::children_of(std::uint32_t index) const {
    return index == kNone ? roots : node(index).children;
}

bool EditModel::is_within(std::uint32_t index, std::uint32_t above) const {
    while (index != kNone && index != above) {
        index = node(index).parent;
    }
    return index == above;
}

bool EditModel::is_shown(std::uint32_t index) const {
    for (; index != kNone; index = node(index).parent) {
        if (!node(index).visible) {
            return false;
        }
    }
    return true;
}

dmat4 EditModel::world_matrix(std::uint32_t index) const {
    dmat4 matrix(1);
    for (; index != kNone; index = node(index).parent) {
        matrix = local_matrix(node(index).local, node(index).shear) * matrix;
    }
    return matrix;
}

std::vector<std::uint32_t> EditModel::in_order() const {
    std::vector<std::uint32_t> order, pending(roots.rbegin(), roots.rend());
    while (!pending.empty()) {
        const std::uint32_t next = pending.back();
        pending.pop_back();
        order.push_back(next);
        const std::vector<std::uint32_t>& children = node(next).children;
        pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    return order;
}

std::size_t EditModel::node_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(nodes, [](const auto& n) { return n != nullptr; }));
}

EditModel model_of(const SceneData& scene, const GltfDocument& document) {
    const Json json = parse_json(document.json_text(), scene.source);
    const Json none = Json::array();
    const auto list = [&](const char* key) -> const Json& {
        const auto found = json.find(key);
        return found != json.end() && found->is_array() ? *found : none;
    };
    const Json& nodes = list("nodes");
    EditModel model;
    model.nodes.resize(document.node_count());
    model.lights.resize(document.light_count());
    model.cameras.resize(document.camera_count());
    model.materials.resize(document.material_count());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const std::uint32_t index = i < scene.file.nodes.size() ? scene.file.nodes[i] : kNone;
        if (index == kNone) {
            continue;
        }
        const NodeData& from = scene.nodes[i];
        const Json& own = nodes[index];
        ModelNode node;
        node.name = from.name;
        node.parent = from.parent == kNone ? kNone : scene.file.nodes[from.parent];
        node.local = from.local;
        node.shear = from.shear;
        node.mesh = index_at(own, "mesh");
        node.camera = index_at(own, "camera");
        node.skin = index_at(own, "skin");
        static const Json::json_pointer light("/extensions/KHR_lights_punctual");
        node.light = own.contains(light) ? index_at(own[light], "light") : kNone;
        node.extras = from.extras;
        node.visible = visibility(own);
        node.loaded = i;
        model.nodes[index] = std::make_shared<const ModelNode>(std::move(node));
    }
    std::vector<bool> seen(model.nodes.size(), false);
    for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i] != nullptr) {
            std::vector<std::uint32_t> children =
                children_in(nodes[i].value("children", none), model, i, seen);
            if (!children.empty()) {
                model.alter(i).children = std::move(children);
            }
        }
    }
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {  // as the importer ordered them
        const std::uint32_t index = i < scene.file.nodes.size() ? scene.file.nodes[i] : kNone;
        if (index != kNone && model.nodes[index]->parent == kNone) {
            model.roots.push_back(index);
        }
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        keep(model.lights, i < scene.file.lights.size() ? scene.file.lights[i] : kNone, scene.lights[i]);
    }
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        keep(model.cameras, i < scene.file.cameras.size() ? scene.file.cameras[i] : kNone, scene.cameras[i]);
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        keep(model.materials, i < scene.file.materials.size() ? scene.file.materials[i] : kNone,
             scene.materials[i]);
    }
    std::vector<std::vector<std::uint32_t>> joints;
    for (const Json& skin : list("skins")) {
        std::vector<std::uint32_t>& own = joints.emplace_back();
        for (const Json& joint : skin.value("joints", none)) {
            own.push_back(static_cast<std::uint32_t>(joint.get<double>()));
        }
    }
    model.joints = std::make_shared<const std::vector<std::vector<std::uint32_t>>>(std::move(joints));
    return model;
}

bool has_extra(const ModelNode& node, const char* key) {
    return !node.extras.empty() && parse_json(node.extras, "extras").contains(key);
}

const Light* light_of(const EditModel& model, std::uint32_t node) {
    const ModelNode* found = model.find(node);
    return found != nullptr && found->light < model.lights.size() ? model.lights[found->light].get()
                                                                  : nullptr;
}

quat written_rotation(const quat& rotation) {
    quat now = rotation;
    for (int i = 0; i < 16; ++i) {  // two or three suffice
        const quat next = read_again(now);
        if (next == now) {
            return now;
        }
        now = next;
    }
    // One in a few thousand becomes another one and that the first again: one a few last bits beside stays.
    for (float size = 0x1p-24f; size < 0x1p-18f; size *= 2) {
        for (int way = 0; way < 5 * 5 * 5 * 5; ++way) {
            quat beside = now;
            for (int part = 0, left = way; part < 4; ++part, left /= 5) {
                beside[part] += static_cast<float>(left % 5 - 2) * size;
            }
            beside = read_again(beside);
            if (read_again(beside) == beside) {
                return beside;
            }
        }
    }
    return now;
}

}  // namespace lanthorn::editor
