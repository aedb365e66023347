#include "lanthorn/runtime/shown_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

bool has_camera(const SceneData& scene) {
    return std::ranges::any_of(scene.nodes, [](const NodeData& node) { return node.camera != kNone; });
}

std::uint32_t find_camera(const SceneData& scene, const std::string& wanted) {
    if (wanted == "auto" || (wanted.empty() && !has_camera(scene))) {
        return kNone;
    }
    std::vector<std::uint32_t> cameras;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].camera != kNone) {
            cameras.push_back(i);
            names.push_back(scene.nodes[i].name);
        }
    }
    const auto found = wanted.empty() ? std::optional<std::size_t>(0) : find_by_name_or_number(names, wanted);
    if (!found) {
        throw InputError(
            scene.source, "",
            fmt::format("found no camera '{}', expected one of {}", wanted,
                        names.empty() ? "none (--camera auto sees everything)" : numbered_names(names)));
    }
    return cameras[*found];
}

}  // namespace lanthorn
