#include "tools/lanthorn/scene/shown_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tools/lanthorn/scene/chosen_camera.h"
#include "tools/lanthorn/scene/default_light.h"

namespace lanthorn::tools {

namespace {

void check_lit_geometry(const FrameScene& frame, const std::string& source) {
    if (frame.instances.empty()) {
        throw InputError(source, "", "found no geometry, expected triangles to render");
    }
    const bool emits = std::any_of(frame.instances.begin(), frame.instances.end(),
                                   [&](const Instance& i) { return frame.material(i).emits(); });
    if (frame.lights.empty() && !emits && !frame.sky) {
        throw InputError(source, "",
                         "found no light, expected a punctual light, an emissive material or a sky");
    }
}

}  // namespace

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
    SceneData scene = import_gltf(file);
    std::vector<std::string> notes = scene.warnings;
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
    App app;
    add_scene_plugins(app);
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
    for (const std::string& note : notes) {
        fmt::print(stderr, "lanthorn: warning: {}: {}\n", file, note);
    }
    return scene;
}

ShownScene::ShownScene(SceneData scene, const SceneView& view) {
    const std::string source = scene.source;
    add_scene_plugins(app_);
    ecs::World& world = app_.world();
    const std::uint32_t camera = find_camera(scene, view.camera);
    const auto entities =
        spawn_scene(app_, std::move(scene), BadExtras::skip);  // load_scene() tells what is bad
    app_.view().camera = camera == kNone ? ecs::kNullEntity : entities[camera];
    play_clip(world, view.animation, source);
    simulates_ = !world.query<ecs::With<physics::Character>>().empty();
    world.query<ecs::Read<physics::RigidBody>>().each([&](const physics::RigidBody& body) {
        simulates_ = simulates_ || body.type == physics::BodyType::dynamic;
    });
    check_lit_geometry(still_scene(world), source);
}

void ShownScene::show_at(double seconds) {
    // Without bodies the last step is all that a moment depends on.
    const double last_step = seconds - kStepSeconds;
    if (!simulates_ && last_step > app_.time().moment) {
        app_.skip_to(last_step);
    }
    app_.show_at(seconds);
}

void ShownScene::hold() {
    ecs::World& world = app_.world();
    world.insert_resource(SimulatedPose());
    for (const ecs::Entity e : world.query<ecs::With<AnimationPlayer>>().entities()) {
        world.remove<AnimationPlayer>(e);
    }
    for (const ecs::Entity e : world.query<ecs::With<Interpolated>>().entities()) {
        world.remove<Interpolated>(e);
    }
}

}  // namespace lanthorn::tools
