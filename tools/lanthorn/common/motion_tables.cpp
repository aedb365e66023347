#include "tools/lanthorn/common/motion_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace lanthorn::tools {

ClipContents clip_contents(const AnimationClip& clip) {
    constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights"};
    std::set<std::uint32_t> nodes;
    std::set<AnimationPath> paths;
    for (const AnimationChannel& channel : clip.channels) {
        nodes.insert(channel.node);
        paths.insert(channel.path);
    }
    std::set<PropertyOwner> owners;
    for (const PropertyChannel& channel : clip.properties) {
        owners.insert(owner_of(channel.property));
        nodes.insert(channel.nodes.begin(), channel.nodes.end());
    }
    ClipContents contents{nodes.size(), {}};
    for (const AnimationPath path : paths) {
        contents.paths.emplace_back(kPaths[static_cast<int>(path)]);
    }
    constexpr const char* kOwners[] = {"lights", "cameras", "materials"};
    for (const PropertyOwner owner : owners) {
        contents.paths.emplace_back(kOwners[static_cast<int>(owner)]);
    }
    return contents;
}

std::size_t most_influences(const Mesh& mesh) {
    std::size_t most = 0;
    for (const SkinInfluences& vertex : mesh.skin) {
        most = std::max(
            most, SkinInfluences::kMost - static_cast<std::size_t>(std::ranges::count(vertex.weights, 0.0f)));
    }
    return most;
}

const char* subdivision_name(SubdivisionScheme scheme) {
    return scheme == SubdivisionScheme::loop ? "loop" : "catmull-clark";
}

TextTable animation_table(const SceneData& scene) {
    TextTable table({"#", "name", "seconds", "channels", "nodes", "moves"});
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        const AnimationClip& clip = scene.animations[i];
        const ClipContents contents = clip_contents(clip);
        table.add({fmt::format("{}", i), clip.name, fmt::format("{:.3f}", clip.duration),
                   fmt::format("{}", clip.channels.size() + clip.properties.size()),
                   fmt::format("{}", contents.nodes), fmt::format("{}", fmt::join(contents.paths, ", "))});
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
        parts.push_back(fmt::format("{} to level {}", subdivision_name(mesh.cage->scheme), mesh.cage->level));
    }
    return parts.empty() ? "-" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace lanthorn::tools
