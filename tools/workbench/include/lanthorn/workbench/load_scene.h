// The scene of a file, with the environment and the default light that a command adds to it.
#pragma once

#include <string>

#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::workbench {

// What every command that shows a scene lets its user choose: what is shown of it, and what it gets.
struct SceneView : SceneChoice {
    bool default_light = true;        // for scenes without any
    std::string environment;          // an image file: the sky; empty: the scene's own
    float environment_intensity = 1;  // nits of 1 in that file
    std::string variant;              // of the file's KHR_materials_variants, the one to show
    bool allow_outside = false;       // let the file name buffers and images outside of its own folder
};

// A scene of a list: "FILE", or "FILE@CAMERA" where there is no file of that whole name.
struct ListedScene {
    std::string file;
    std::string name;  // the file's without its ending, and "-CAMERA"
    SceneView view;    // with that camera, where one is named
};
// Takes apart what a list says of a scene; a camera named there replaces `view`'s. Whether the file is there
// shows only when it is loaded.
ListedScene listed_scene(const std::string& text, SceneView view);

// The glTF file's scene with `view`'s environment, and a default light if it allows and it is needed. Among
// its warnings is a line for the light or camera that it lacks, and for extras that no component takes.
// Throws InputError as import_gltf().
SceneData load_scene(const std::string& file, const SceneView& view);

}  // namespace lanthorn::workbench
