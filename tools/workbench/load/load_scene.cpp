#include "lanthorn/workbench/load_scene.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/shown_scene.h"
#include "tools/workbench/load/default_light.h"

namespace lanthorn::workbench {

ListedScene listed_scene(const std::string& text, SceneView view) {
    std::string file = text, ending;
    const std::size_t at = text.rfind('@');
    std::error_code ignored;
    if (at != std::string::npos && !std::filesystem::exists(text, ignored)) {
        file = text.substr(0, at);
        view.camera = text.substr(at + 1);
        ending = '-' + view.camera;
    }
    std::string name = std::filesystem::path(file).stem().string() + ending;
    return {std::move(file), std::move(name), std::move(view)};
}

SceneData load_scene(const std::string& file, const SceneView& view) {
    SceneData scene = import_gltf(file, {.variant = view.variant, .allow_outside = view.allow_outside});
    std::vector<std::string>& notes = scene.warnings;
    if (view.camera.empty() && !has_camera(scene)) {
        notes.emplace_back("found no camera; one that sees everything is used (--camera auto)");
    }
    if (!view.environment.empty()) {
        add_environment(scene, view.environment, view.environment_intensity);
    }
    if (view.default_light) {
        if (auto note = add_default_light(scene, view.camera)) {
            notes.push_back(std::move(*note));
        }
    }
    if (view.box) {
        place_box(scene, *view.box);
    }
    App app;
    add_scene_plugins(app);
    if (view.declare) {
        view.declare(app.registry());
    }
    for (const NodeData& node : scene.nodes) {
        if (!node.extras.empty()) {
            const ecs::ExtrasReading reading = ecs::read_extras(app.registry(), node.extras);
            for (const ecs::JsonProblem& problem : reading.skipped) {
                notes.push_back(fmt::format("node '{}': {}: skipped", node.name, problem.line()));
            }
            for (const ecs::JsonProblem& problem : reading.ignored) {
                notes.push_back(fmt::format("node '{}': {}: ignored", node.name, problem.line()));
            }
        }
    }
    return scene;
}

}  // namespace lanthorn::workbench
