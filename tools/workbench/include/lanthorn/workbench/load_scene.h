// The scene of a file, with the environment and the default light that a command adds to it.
#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"
#include "lanthorn/workbench/shown_scene.h"

namespace lanthorn::workbench {

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
