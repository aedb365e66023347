#include "tools/editor/core/node_mark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "tools/editor/core/node_path.h"

namespace lanthorn::editor {

namespace {

std::string kind_of(const EditModel& model, const ModelNode& node) {
    if (node.light < model.lights.size() && model.lights[node.light] != nullptr) {
        constexpr const char* kTypes[] = {"directional", "point", "spot"};
        return kTypes[static_cast<int>(model.lights[node.light]->type)];
    }
    return node.mesh != kNone ? "mesh" : node.camera != kNone ? "camera" : "empty";
}

std::uint64_t mesh_of(const ModelNode& node, const std::function<std::uint64_t(std::uint32_t)>& mesh_hash) {
    return node.mesh != kNone && mesh_hash ? mesh_hash(node.mesh) : 0;
}

// Places are one where a file that was written with fewer digits would put them.
bool is_at(const dvec3& a, const dvec3& b) {
    return glm::length(a - b) <= 1e-4 * std::max({glm::length(a), glm::length(b), 1e-2});
}

constexpr std::size_t kMostBelow = 8;

std::vector<std::string> names_below(const EditModel& model, std::uint32_t node, std::size_t most) {
    std::vector<std::string> names;
    for (const std::uint32_t child : model.node(node).children) {
        const std::string& name = model.node(child).name;
        if (!name.empty() && std::ranges::find(names, name) == names.end() && names.size() < most) {
            names.push_back(name);
        }
    }
    return names;
}

// Most of the children that it had stand under this node.
bool has_most_of(const EditModel& model, std::uint32_t node, const std::vector<std::string>& below) {
    const std::vector<std::string> names = names_below(model, node, ~std::size_t(0));
    const auto there = static_cast<std::size_t>(std::ranges::count_if(
        below, [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); }));
    return there >= 2 && 3 * there >= 2 * below.size();
}

std::uint32_t only_one(const std::vector<std::uint32_t>& found) {
    return found.size() == 1 ? found.front() : kNone;
}

}  // namespace

NodeMark mark_of(const EditModel& model, std::uint32_t index, std::string_view path,
                 const std::function<std::uint64_t(std::uint32_t)>& mesh_hash) {
    const ModelNode& node = model.node(index);
    NodeMark mark;
    mark.node = index;
    mark.path = path;
    mark.name = node.name;
    mark.mesh = mesh_of(node, mesh_hash);
    mark.kind = kind_of(model, node);
    mark.at = node.local.translation;
    mark.world = dvec3(model.world_matrix(index)[3]);
    mark.made = node.made;
    mark.below = names_below(model, index, kMostBelow);
    mark.alone = !node.name.empty() && std::ranges::count_if(model.nodes, [&](const auto& other) {
                                           return other != nullptr && other->name == node.name;
                                       }) == 1;
    return mark;
}

std::string to_text(const NodeMark& mark) {
    nlohmann::json json = {{"node", mark.node},
                           {"path", mark.path},
                           {"kind", mark.kind},
                           {"at", {mark.at.x, mark.at.y, mark.at.z}},
                           {"world", {mark.world.x, mark.world.y, mark.world.z}}};
    if (!mark.name.empty()) {
        json["name"] = mark.name;
    }
    if (mark.mesh != 0) {
        json["mesh"] = fmt::format("{:016x}", mark.mesh);
    }
    if (mark.made) {
        json["made"] = true;
    }
    if (mark.alone) {
        json["alone"] = true;
    }
    if (!mark.below.empty()) {
        json["below"] = mark.below;
    }
    return json.dump();
}

NodeMark mark_from(std::string_view text) {
    const nlohmann::json json = parse_json_object(text, "recovery log", "a node's mark");
    NodeMark mark;
    try {
        mark.node = json.at("node").get<std::uint32_t>();
        mark.path = json.at("path").get<std::string>();
        mark.kind = json.at("kind").get<std::string>();
        for (int i = 0; i < 3; ++i) {
            mark.at[i] = json.at("at").at(static_cast<std::size_t>(i)).get<double>();
            mark.world[i] = json.at("world").at(static_cast<std::size_t>(i)).get<double>();
        }
        mark.name = json.value("name", std::string());
        mark.mesh = std::stoull(json.value("mesh", std::string("0")), nullptr, 16);
        mark.made = json.value("made", false);
        mark.alone = json.value("alone", false);
        mark.below = json.value("below", std::vector<std::string>());
    } catch (const std::exception&) {
        throw InputError(fmt::format("recovery log: found {}, expected a node's mark", text));
    }
    return mark;
}

std::uint32_t find_marked(const EditModel& model, const NodeMark& mark,
                          const std::function<std::uint64_t(std::uint32_t)>& mesh_hash) {
    // Which nodes could it be at all: of its kind, and with its mesh.
    const auto is_alike = [&](const ModelNode& node) {
        return kind_of(model, node) == mark.kind && (mark.mesh == 0 || mesh_of(node, mesh_hash) == mark.mesh);
    };
    const auto stands_there = [&](std::uint32_t i) {
        return is_at(model.node(i).local.translation, mark.at) ||
               is_at(dvec3(model.world_matrix(i)[3]), mark.world);
    };
    // Where its path leads, if nothing there speaks against it.
    if (mark.path.find('#') == std::string::npos) {
        const std::uint32_t there = find_node(model, mark.path);
        if (there != kNone && kind_of(model, model.node(there)) == mark.kind) {
            // Its mesh may be another one by now: then the place must be the same.
            if (is_alike(model.node(there)) || stands_there(there)) {
                return there;
            }
            return kNone;
        }
    }
    std::vector<std::uint32_t> named, placed;
    for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i] == nullptr || !is_alike(*model.nodes[i])) {
            continue;
        }
        const bool has_name = model.nodes[i]->name == mark.name;
        if (has_name && !mark.name.empty()) {
            named.push_back(i);
        }
        // Without its name it is known by what it shows, or by what stands under it: an empty node at the
        // origin is like any other.
        const bool shows = mark.kind != "empty" && mark.kind != "camera";
        if (stands_there(i) && (shows || has_most_of(model, i, mark.below))) {
            placed.push_back(i);
        }
    }
    // A mesh and a name that nobody else has or had are enough; else the place must speak for it.
    if (named.size() == 1 && mark.alone && mark.mesh != 0) {
        return named.front();
    }
    std::erase_if(named, [&](std::uint32_t i) { return !stands_there(i); });
    return named.empty() ? only_one(placed) : only_one(named);
}

bool is_marked(const EditModel& model, std::uint32_t node, const NodeMark& mark,
               const std::function<std::uint64_t(std::uint32_t)>& mesh_hash) {
    const ModelNode& found = model.node(node);
    return found.name == mark.name && kind_of(model, found) == mark.kind &&
           mesh_of(found, mesh_hash) == mark.mesh &&
           (is_at(found.local.translation, mark.at) || is_at(dvec3(model.world_matrix(node)[3]), mark.world));
}

}  // namespace lanthorn::editor
