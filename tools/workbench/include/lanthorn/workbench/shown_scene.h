// A scene as a command shows it: which camera, which moment, and what it gets if it has no light of its own.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::workbench {

// What every command that shows a scene lets its user choose.
struct SceneView {
    std::string camera;  // a camera node's name or a camera's number; empty: the first, or "auto" if there is
                         // none; "auto": one that sees everything
    std::string animation;            // as play_clip() takes it
    std::optional<double> time;       // seconds of it; each command has its own default
    bool default_light = true;        // for scenes without any
    std::string environment;          // an image file: the sky; empty: the scene's own
    float environment_intensity = 1;  // nits of 1 in that file
    std::string variant;              // of the file's KHR_materials_variants, the one to show
    bool allow_outside = false;       // let the file name buffers and images outside of its own folder
    // The components that nodes' extras may name beside the engine's: game::declare_components. Empty: none.
    std::function<void(ecs::Registry&)> declare = {};
};

// An App with the scene in it. For pictures add gi::add_picture_plugins().
class ShownScene {
  public:
    // Throws InputError naming `scene.source` if there is no geometry, no light, or no camera or animation of
    // that name. Takes the assets out of the scene.
    ShownScene(SceneData scene, const SceneView& view);

    // The App that shows it. Its camera, lights and systems may be changed between frames.
    App& app() { return app_; }
    // The App's entities and resources.
    ecs::World& world() { return app_.world(); }
    ecs::Entity camera() const { return app_.world().resource<View>().camera; }  // null for "auto"
    // Shows that moment of the scene, seconds since its start and not before the one shown last. What is
    // shown is a function of `seconds` alone: bodies take all their steps.
    void show_at(double seconds);
    // From now on everything stands as it is shown, whatever moved it; show it again by app().show().
    void hold();
    // What the App showed last.
    const FrameScene& frame() const { return app_.world().resource<FrameScene>(); }

  private:
    App app_;
    bool simulates_ = false;  // bodies or characters that move
};

}  // namespace lanthorn::workbench
