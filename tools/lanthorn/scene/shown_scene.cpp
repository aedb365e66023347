#include "tools/lanthorn/scene/shown_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtx/quaternion.hpp>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/reference/material_table.h"
#include "lanthorn/reference/trace_scene.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::tools {

namespace {

constexpr float kDefaultIlluminance = 1000;  // lux: a bright room; exposure follows anyway
constexpr float kShoulder = 0.35f;           // of the distance to what is looked at, upwards and to the left
constexpr float kWidestCone = 1.3f;          // radians
constexpr float kBeforeWall = 0.8f;          // of the way to a surface that is nearer

bool has_camera(const SceneData& scene) {
    return std::ranges::any_of(scene.nodes, [](const NodeData& node) { return node.camera != kNone; });
}

bool has_light(const SceneData& scene) {
    return std::ranges::any_of(scene.nodes, [&](const NodeData& node) {
        return node.light != kNone || std::ranges::any_of(node.meshes, [&](std::uint32_t mesh) {
                   return scene.materials[scene.meshes[mesh].material].emits();
               });
    });
}

// The node whose camera is meant; kNone for one that sees everything.
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

void check_lit_geometry(const FrameScene& frame, const std::string& source) {
    if (frame.instances.empty()) {
        throw InputError(source, "", "found no geometry, expected triangles to render");
    }
    const bool emits = std::any_of(frame.instances.begin(), frame.instances.end(),
                                   [&](const Instance& i) { return frame.material(i).emits(); });
    if (frame.lights.empty() && !emits) {
        throw InputError(source, "", "found no light, expected a punctual light or an emissive material");
    }
}

// A light for what `frame`'s camera sees, in render space: a spot on all of a model seen from outside, which
// sends no photon past it; in a room, a point light.
struct ShoulderLight {
    Light light;
    vec3 position{0};
    vec3 target{0};
};

ShoulderLight shoulder_light(const FrameScene& frame) {
    const CameraView& view = frame.camera;
    const mat3 to_render = glm::transpose(mat3(view.view));
    const float diagonal = frame.diagonal();
    const bool inside = glm::all(glm::greaterThan(view.position, frame.bounds.lower)) &&
                        glm::all(glm::lessThan(view.position, frame.bounds.upper));
    const reference::MaterialTable materials(*frame.assets);
    const reference::TraceScene scene(frame, materials);
    const auto first_surface = [&](const vec3& direction, float farthest) {
        reference::SurfaceHit hit;
        return scene.intersect(view.position, direction, 0, farthest, reference::Blended::ignored, hit)
                   ? hit.t
                   : farthest;
    };
    ShoulderLight result;
    result.target = inside ? view.position - to_render[2] * first_surface(-to_render[2], diagonal)
                           : frame.bounds.centre();
    const float reach = std::max(glm::length(result.target - view.position), 0.01f * diagonal);
    const vec3 aside = kShoulder * reach * (to_render[1] - to_render[0]);
    const float room = first_surface(aside, 1);
    result.position = view.position + aside * (room < 1 ? kBeforeWall * room : 1.0f);
    const float distance = std::max(glm::length(result.target - result.position), 0.01f * diagonal);
    result.light.intensity = kDefaultIlluminance * distance * distance;
    if (!inside) {
        result.light.type = LightType::spot;
        result.light.inner_cone =
            std::min(std::asin(std::min(0.5f * diagonal / distance, 1.0f)), kWidestCone);
        result.light.outer_cone = std::min(1.1f * result.light.inner_cone + 0.01f, kPi / 2);
    }
    return result;
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

std::optional<std::string> add_default_light(SceneData& scene, const std::string& camera) {
    if (has_light(scene)) {
        return std::nullopt;
    }
    ecs::World world;
    const std::uint32_t eye = find_camera(scene, camera);
    const std::vector<ecs::Entity> entities = spawn(world, scene);
    const FrameScene frame = still_scene(world, eye == kNone ? ecs::kNullEntity : entities[eye]);
    if (frame.instances.empty()) {
        return std::nullopt;
    }
    const ShoulderLight shoulder = shoulder_light(frame);
    NodeData node;
    node.name = "default light";
    node.light = static_cast<std::uint32_t>(scene.lights.size());
    node.local.translation = frame.origin + dvec3(shoulder.position);
    node.local.rotation = glm::rotation(vec3(0, 0, -1), glm::normalize(shoulder.target - shoulder.position));
    scene.lights.push_back(shoulder.light);
    scene.nodes.push_back(std::move(node));
    return "found no light; one over the camera's shoulder is added (--no-default-light: none)";
}

SceneData load_scene(const std::string& file, const SceneView& view) {
    SceneData scene = import_gltf(file);
    std::vector<std::string> notes = scene.warnings;
    if (view.camera.empty() && !has_camera(scene)) {
        notes.emplace_back("found no camera; one that sees everything is used (--camera auto)");
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
