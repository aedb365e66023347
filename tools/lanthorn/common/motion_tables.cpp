#include "tools/lanthorn/common/motion_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace lanthorn::tools {

namespace {

std::size_t most_influences(const Mesh& mesh) {
    std::size_t most = 0;
    for (const SkinInfluences& vertex : mesh.skin) {
        most = std::max(
            most, SkinInfluences::kMost - static_cast<std::size_t>(std::ranges::count(vertex.weights, 0.0f)));
    }
    return most;
}

std::string paths_text(const AnimationClip& clip) {
    constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights"};
    std::set<AnimationPath> paths;
    for (const AnimationChannel& channel : clip.channels) {
        paths.insert(channel.path);
    }
    std::string text;
    for (const AnimationPath path : paths) {
        text += (text.empty() ? "" : ", ") + std::string(kPaths[static_cast<int>(path)]);
    }
    return text;
}

}  // namespace

TextTable animation_table(const SceneData& scene) {
    TextTable table({"#", "name", "seconds", "channels", "nodes", "moves"});
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        const AnimationClip& clip = scene.animations[i];
        std::set<std::uint32_t> nodes;
        for (const AnimationChannel& channel : clip.channels) {
            nodes.insert(channel.node);
        }
        table.add({fmt::format("{}", i), clip.name, fmt::format("{:.3f}", clip.duration),
                   fmt::format("{}", clip.channels.size()), fmt::format("{}", nodes.size()),
                   paths_text(clip)});
    }
    return table;
}

TextTable skin_table(const SceneData& scene) {
    TextTable table({"#", "name", "joints"});
    for (std::size_t i = 0; i < scene.skins.size(); ++i) {
        table.add(
            {fmt::format("{}", i), scene.skins[i].name, fmt::format("{}", scene.skins[i].joints.size())});
    }
    return table;
}

std::string deformation_text(const Mesh& mesh) {
    std::vector<std::string> parts;
    if (!mesh.skin.empty()) {
        parts.push_back(fmt::format("skin of up to {} joints", most_influences(mesh)));
    }
    if (!mesh.morphs.empty()) {
        parts.push_back(fmt::format("{} morph targets", mesh.morphs.size()));
    }
    if (mesh.cage) {
        const bool loop = mesh.cage->scheme == SubdivisionScheme::loop;
        parts.push_back(fmt::format("{} to level {}", loop ? "loop" : "catmull-clark", mesh.cage->level));
    }
    return parts.empty() ? "-" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace lanthorn::tools
