#include "tools/editor/core/play_changes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/node_path.h"

namespace lanthorn::editor {

namespace {

// Relative to the document's parent, both as they were then.
std::optional<dmat4> local_in(const std::map<std::uint32_t, PlayedNode>& played, const EditModel& model,
                              std::uint32_t node) {
    const auto found = played.find(node);
    if (found == played.end()) {
        return std::nullopt;
    }
    const std::uint32_t parent = model.node(node).parent;
    const auto above = played.find(parent);
    return above == played.end() ? found->second.to_world
                                 : glm::inverse(above->second.to_world) * found->second.to_world;
}

glm::dquat turn_of(const dmat4& m) {
    return glm::normalize(glm::quat_cast(
        glm::dmat3(glm::normalize(dvec3(m[0])), glm::normalize(dvec3(m[1])), glm::normalize(dvec3(m[2])))));
}

// What moved, onto the node's own transform: its scale stays.
void add_motion(const EditModel& model, std::uint32_t node, const dmat4& before, const dmat4& after,
                PlayChange& change, std::vector<std::string>& words) {
    const Transform& local = model.node(node).local;
    const std::string path = word(path_of(model, node));
    const dvec3 way = dvec3(after[3]) - dvec3(before[3]);
    if (glm::length(way) >= kLeastMetres) {
        const dvec3 at = local.translation + way;
        change.lines.push_back(
            fmt::format("move {} {} {} {}", path, number(at.x), number(at.y), number(at.z)));
        words.push_back(fmt::format("{:.2g} m away", glm::length(way)));
    }
    const glm::dquat turn = turn_of(after) * glm::inverse(turn_of(before));
    const double degrees = glm::degrees(2 * std::acos(std::min(1.0, std::abs(turn.w))));
    if (degrees >= kLeastDegrees) {
        const glm::dquat to = glm::normalize(turn * glm::dquat(local.rotation));
        change.lines.push_back(fmt::format("rotate {} {} {} {} {}", path, number(static_cast<float>(to.x)),
                                           number(static_cast<float>(to.y)), number(static_cast<float>(to.z)),
                                           number(static_cast<float>(to.w))));
        words.push_back(fmt::format("turned by {:.0f} degrees", degrees));
    }
}

void add_light(const EditModel& model, std::uint32_t node, const PlayedNode& before, const PlayedNode& after,
               PlayChange& change, std::vector<std::string>& words) {
    if (!before.has_light || !after.has_light || light_of(model, node) == nullptr) {
        return;
    }
    const std::string path = word(path_of(model, node));
    if (before.light.intensity != after.light.intensity) {
        change.lines.push_back(fmt::format("set {} light.intensity {}", path, number(after.light.intensity)));
        words.push_back(fmt::format("gives {:.3g} instead of {:.3g} cd",
                                    static_cast<double>(after.light.intensity),
                                    static_cast<double>(before.light.intensity)));
    }
    if (before.light.colour != after.light.colour) {
        const vec3& c = after.light.colour;
        change.lines.push_back(
            fmt::format("set {} light.colour [{},{},{}]", path, number(c.x), number(c.y), number(c.z)));
        words.emplace_back("another colour");
    }
}

}  // namespace

std::map<std::uint32_t, PlayedNode> played_nodes(const ecs::World& world, const SceneData& scene) {
    std::map<std::uint32_t, PlayedNode> nodes;
    world.query<ecs::Read<Source>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const Source& source, const WorldTransform& at) {
            if (source.node >= scene.file.nodes.size() || scene.file.nodes[source.node] == kNone) {
                return;
            }
            PlayedNode& node = nodes[scene.file.nodes[source.node]];
            node.to_world = at.matrix;
            if (const LightComponent* light = world.try_get<LightComponent>(e)) {
                node.light = light->light;
                node.has_light = true;
            }
        });
    return nodes;
}

std::vector<PlayChange> play_changes(const EditModel& model,
                                     const std::map<std::uint32_t, PlayedNode>& before,
                                     const std::map<std::uint32_t, PlayedNode>& after,
                                     const std::vector<std::uint32_t>& animated) {
    std::vector<std::uint32_t> players;
    std::vector<PlayChange> changes;
    for (const std::uint32_t node : model.in_order()) {
        if (has_extra(model.node(node), "player")) {
            players.push_back(node);
        }
        const bool left_out =
            model.node(node).camera != kNone || std::ranges::find(animated, node) != animated.end() ||
            std::ranges::any_of(players, [&](std::uint32_t player) { return model.is_within(node, player); });
        const std::optional<dmat4> first = local_in(before, model, node), last = local_in(after, model, node);
        if (left_out || !first || !last) {
            continue;
        }
        PlayChange change;
        change.node = node;
        std::vector<std::string> words;
        add_motion(model, node, *first, *last, change, words);
        add_light(model, node, before.at(node), after.at(node), change, words);
        if (change.lines.empty()) {
            continue;
        }
        change.title = fmt::format("{}: {}", called(model, node), fmt::join(words, ", "));
        changes.push_back(std::move(change));
    }
    return changes;
}

}  // namespace lanthorn::editor
