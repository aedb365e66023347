// A scene as a command shows it: which camera, which moment, and what it gets if it has no light of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/scene_data.h"
#include "tools/lanthorn/scene/scene_player.h"

namespace lanthorn::tools {

// What every command that shows a scene lets its user choose.
struct SceneView {
    std::string camera;  // a camera node's name or a camera's number; empty: the first, or "auto" if there is
                         // none; "auto": one that sees everything
    std::string animation;       // as ScenePlayer takes it
    std::optional<double> time;  // seconds of it; each command has its own default
    bool default_light = true;   // for scenes without any
};

// Gives a scene with geometry but neither a punctual light nor an emissive surface a light above the left
// shoulder of the camera (SceneView's), nearer if a surface is in the way, with 1000 lx on what the camera
// looks at: a spot that holds all of the scene for a camera outside its bounds, a point light for one inside.
// Returns one line for the user if it did, else nothing. Throws InputError for a camera that is not there.
// Cheap for scenes with light; for others a copy of the scene and Embree's structures.
std::optional<std::string> add_default_light(SceneData& scene, const std::string& camera);

// The glTF file's scene, with a default light if `view` allows and it is needed. Its warnings, and a line for
// the light or camera that it lacks, go to standard error. Throws InputError as import_gltf().
SceneData load_scene(const std::string& file, const SceneView& view);

class ShownScene {
  public:
    // Throws InputError naming `scene.source` if there is no geometry, no light, or no camera or animation of
    // that name. Takes the assets out of the scene.
    ShownScene(SceneData scene, const SceneView& view);

    ecs::World& world() { return world_; }
    ecs::Entity camera() const { return camera_; }  // null for "auto"
    ScenePlayer& player() { return player_; }
    // Brings the world to that moment of the animation, as ScenePlayer does.
    void show(double seconds) { player_.show(seconds); }

  private:
    std::string source_;
    ecs::World world_;
    ecs::Entity camera_;
    ScenePlayer player_;
};

}  // namespace lanthorn::tools
