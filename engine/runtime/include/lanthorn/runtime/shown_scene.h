// A scene that is shown: an App with everything in it, seen through one of its cameras. Games fill it with
// their level, tools with what a file holds.
//
//   ShownScene shown(import_gltf("room.glb"), {.camera = "door"});
//   gi::add_picture_plugins(shown.app(), "medium");
//   shown.show_at(0.5);
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// What is shown of a scene that is looked at.
struct SceneChoice {
    // A camera node's name or a camera's number; empty: the first, or "auto" if there is none; "auto": one
    // that sees everything.
    std::string camera = {};
    std::string animation = {};       // as play_clip() takes it
    std::optional<double> time = {};  // seconds of it; each program has its own default
    // The components that nodes' extras may name beside the engine's. Empty: none.
    std::function<void(ecs::Registry&)> declare = {};
};

// Whether a camera is among its nodes.
bool has_camera(const SceneData& scene);

// The node whose camera is meant, by SceneChoice::camera; kNone for one that sees everything. Throws
// InputError for one that is not there.
std::uint32_t find_camera(const SceneData& scene, const std::string& wanted);

// An App with the scene in it: for pictures add gi::add_picture_plugins(), which needs an OpenGL context.
class ShownScene {
  public:
    // Filled by a program: `fill` gets an App with the plugins of every scene (add_scene_plugins), to which
    // it adds its own and what there is, with a camera in View::camera. Throws what `fill` throws.
    explicit ShownScene(const std::function<void(App&)>& fill);
    // What is in a file, to be looked at; extras that no component takes are skipped. Takes the assets out of
    // the scene. Throws InputError naming `scene.source` if there is no geometry, no light, or no camera or
    // animation of that name.
    ShownScene(SceneData scene, const SceneChoice& choice);

    // The App that shows it. Its camera, lights and systems may be changed between frames.
    App& app() { return app_; }
    const App& app() const { return app_; }  // the same to read
    // The App's entities and resources.
    ecs::World& world() { return app_.world(); }
    const ecs::World& world() const { return app_.world(); }                // the same to read
    ecs::Entity camera() const { return world().resource<View>().camera; }  // null for "auto"
    // What the App showed last.
    const FrameScene& frame() const { return world().resource<FrameScene>(); }

    // Shows that moment of the scene, seconds since its start and not before the one shown last. What is
    // shown is a function of `seconds` alone: bodies, and systems that a program has added, take all their
    // steps.
    void show_at(double seconds);
    // From now on everything stands as it is shown, whatever moved it; show it again by app().show().
    void hold();

    // All declared components as they are, as bytes: O(bytes of components). Throws Error for a component
    // that is not declared.
    std::string state() const;
    // Back to it, also by a build with other components (ecs::Snapshot::from_bytes). Throws InputError naming
    // `source` for what is no state; returns what this build has no place for, for one line.
    std::vector<std::string> restore(std::string_view state, std::string_view source);

  private:
    App app_;
    bool simulates_ = true;  // something depends on the steps before
};

}  // namespace lanthorn
