#include "game/level.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

using Json = nlohmann::json;

Json extras_of(const SceneData& scene, const NodeData& node) {
    if (node.extras.empty()) {
        return Json::object();
    }
    Json extras = Json::parse(node.extras, nullptr, false);
    if (!extras.is_object()) {
        throw InputError(scene.source, "node '" + node.name + "': extras", "expected an object");
    }
    return extras;
}

std::vector<dmat4> world_matrices(const SceneData& scene) {
    std::vector<dmat4> worlds;
    worlds.reserve(scene.nodes.size());
    for (const NodeData& node : scene.nodes) {
        const dmat4 local = node.local.matrix();
        worlds.push_back(node.parent == kNone ? local : worlds[node.parent] * local);
    }
    return worlds;
}

double yaw_of(const dmat4& world) {
    return std::atan2(-world[0].z, world[0].x);
}

// The upright box around the node's meshes; around all of its corners if the node is tilted.
Box box_of(const SceneData& scene, const NodeData& node, const dmat4& world) {
    Aabb bounds;
    for (const std::uint32_t mesh : node.meshes) {
        bounds.add(scene.meshes[mesh].bounds);
    }
    if (bounds.empty()) {
        throw InputError(scene.source, "node '" + node.name + "'",
                         "has a collider, expected a mesh to take its size from");
    }
    const dvec3 half = 0.5 * dvec3(bounds.size());
    const dvec3 x = half.x * dvec3(world[0]), y = half.y * dvec3(world[1]), z = half.z * dvec3(world[2]);
    const dvec3 centre(world * dvec4(dvec3(bounds.centre()), 1));
    const double level = 1e-4 * (glm::length(x) + glm::length(y) + glm::length(z));
    const bool upright = std::abs(x.y) + std::abs(z.y) + std::abs(y.x) + std::abs(y.z) < level;
    if (upright) {
        return {centre, {glm::length(x), glm::length(y), glm::length(z)}, yaw_of(world)};
    }
    return {centre, glm::abs(x) + glm::abs(y) + glm::abs(z), 0};
}

// kNone if there is none. What the game moves must not hang on something else.
std::uint32_t find_node(const SceneData& scene, const std::string& name, bool moves = false) {
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].name == name) {
            if (moves && scene.nodes[i].parent != kNone) {
                throw InputError(scene.source, "node '" + name + "'",
                                 "found below another node, expected a root node");
            }
            return i;
        }
    }
    return kNone;
}

bool within(const SceneData& scene, std::uint32_t node, std::uint32_t ancestor) {
    while (node != kNone && node != ancestor) {
        node = scene.nodes[node].parent;
    }
    return node == ancestor;
}

double number_or(const SceneData& scene, std::uint32_t node, const char* key, double otherwise) {
    const Json extras = extras_of(scene, scene.nodes[node]);
    const auto found = extras.find(key);
    if (found == extras.end()) {
        return otherwise;
    }
    if (!found->is_number()) {
        throw InputError(scene.source, "node '" + scene.nodes[node].name + "': extras: " + key,
                         "expected a number");
    }
    return found->get<double>();
}

}  // namespace

Level find_level(const SceneData& scene) {
    const std::vector<dmat4> worlds = world_matrices(scene);
    const auto place = [&](std::uint32_t node) { return dvec3(worlds[node][3]); };
    Level level;

    const std::uint32_t start = find_node(scene, "player_start");
    if (start == kNone) {
        throw InputError(scene.source, "nodes", "found none named 'player_start', expected one to begin at");
    }
    level.start = place(start);
    level.start_yaw = yaw_of(worlds[start]);

    const std::uint32_t door = find_node(scene, "door", true);
    if (door != kNone) {
        level.door = DoorPlace{.node = door, .hinge = place(door)};
        level.door->open_angle = number_or(scene, door, "open_angle", level.door->open_angle);
    }
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const Json extras = extras_of(scene, scene.nodes[i]);
        const auto collider = extras.find("collider");
        if (collider == extras.end()) {
            continue;
        }
        if (*collider != "box") {
            throw InputError(scene.source, "node '" + scene.nodes[i].name + "': extras: collider",
                             "found " + collider->dump() + ", expected \"box\"");
        }
        Box box = box_of(scene, scene.nodes[i], worlds[i]);
        if (door != kNone && within(scene, i, door)) {
            box.centre -= level.door->hinge;
            level.door->leaf.push_back(box);
        } else {
            level.walls.push_back(box);
        }
    }
    if (level.door && !level.door->leaf.empty()) {
        level.door->middle = level.door->leaf.front().centre;
    }

    const std::uint32_t lantern = find_node(scene, "lantern", true);
    if (lantern != kNone) {
        level.lantern = LanternPlace{.node = lantern, .light_node = find_node(scene, "lantern-light")};
        level.lantern->position = place(lantern);
        level.lantern->yaw = yaw_of(worlds[lantern]);
        level.lantern->handle = number_or(scene, lantern, "handle", level.lantern->handle);
    }
    const std::uint32_t sensor = find_node(scene, "far_sensor");
    if (sensor != kNone) {
        level.far_sensor = place(sensor);
    }
    return level;
}

}  // namespace lanthorn::game
