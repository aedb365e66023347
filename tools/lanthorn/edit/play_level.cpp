#include "tools/lanthorn/edit/play_level.h"

#include <fmt/format.h>

#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/game_program.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/edit/recorded_state.h"

namespace lanthorn::tools {

namespace {

using editor::EditModel;
using editor::ModelNode;

constexpr double kEyes = 1.62;  // metres above the ground, of a player that is made
constexpr const char* kRecording = "played.rec";

std::uint32_t node_with(const EditModel& model, const char* component) {
    for (const std::uint32_t node : model.in_order()) {
        if (has_extra(model.node(node), component)) {
            return node;
        }
    }
    return kNone;
}

// Where a node's parent is, without its own transform.
dmat4 above(const EditModel& model, std::uint32_t node) {
    const std::uint32_t parent = model.node(node).parent;
    return parent == kNone ? dmat4(1) : model.world_matrix(parent);
}

void make_player(GltfDocument& document, const EditModel& model, const Transform& look) {
    for (const std::uint32_t node : model.in_order()) {
        const ModelNode& found = model.node(node);
        if (found.mesh != kNone && !has_extra(found, "collider") && !has_extra(found, "body")) {
            document.set_extra(node, "collider", R"({"shape":"mesh"})");
        }
    }
    const auto player = static_cast<std::uint32_t>(document.add_node("player"));
    Transform at;
    at.translation = look.translation - dvec3(0, kEyes, 0);
    document.set_transform(player, at);
    document.set_extras(player, R"({"player":{},"character":{"height":1.75,"radius":0.28}})");
    const std::size_t eyes = document.add_node("player-eyes", player);
    Transform turned;
    turned.translation = dvec3(0, kEyes, 0);
    turned.rotation = look.rotation;
    document.set_transform(eyes, turned);
    Camera lens;
    document.set_node_camera(eyes, static_cast<std::uint32_t>(document.add_camera(lens)));
    document.set_extras(eyes, R"({"eyes":{}})");
}

}  // namespace

GltfDocument play_document(const editor::EditSession& session) {
    GltfDocument document = session.document();
    const EditModel& model = session.model();
    const Transform look = transform_of(session.pose());
    const std::uint32_t player = node_with(model, "player"), eyes = node_with(model, "eyes");
    if (player == kNone || eyes == kNone) {
        make_player(document, model, look);
        return document;
    }
    // The eyes keep their place in the player.
    const dvec3 of_eyes = dvec3(model.world_matrix(eyes)[3]) - dvec3(model.world_matrix(player)[3]);
    Transform stands = model.node(player).local;
    stands.translation = dvec3(glm::inverse(above(model, player)) * dvec4(look.translation - of_eyes, 1));
    document.set_transform(player, stands);
    const dmat4 parent = above(model, eyes);
    glm::dmat3 axes(glm::normalize(dvec3(parent[0])), glm::normalize(dvec3(parent[1])),
                    glm::normalize(dvec3(parent[2])));
    Transform sees = model.node(eyes).local;
    sees.rotation = quat(glm::inverse(glm::dquat(axes)) * glm::dquat(look.rotation));
    document.set_transform(eyes, sees);
    return document;
}

std::vector<std::string> play_command(const editor::EditSession& session, const Settings& settings,
                                      const std::filesystem::path& level, ivec2 size) {
    std::vector<std::string> command{game_program(),
                                     "--level",
                                     level.string(),
                                     "--size",
                                     fmt::format("{}x{}", size.x, size.y),
                                     "--escape-leaves",
                                     "--record",
                                     (level.parent_path() / kRecording).string()};
    for (const SettingInfo& info : settings.schema().all()) {
        if (!settings.is_default(info.name)) {
            command.insert(command.end(), {"--set", info.name + '=' + settings.text(info.name)});
        }
    }
    play_document(session).write(level);
    return command;
}

edit_window::PlayedScene played_scene(const std::filesystem::path& folder) {
    return recorded_state((folder / kRecording).string(), (folder / "level.glb").string(), std::nullopt)
        .scene;
}

}  // namespace lanthorn::tools
