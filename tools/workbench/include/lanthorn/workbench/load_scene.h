// The scene of a file, with the environment and the default light that a command adds to it.
#pragma once

#include <optional>
#include <string>

#include "lanthorn/core/math.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/workbench/motions.h"

namespace lanthorn::workbench {

// What every command that shows a scene lets its user choose: what is shown of it, and what it gets.
struct SceneView : SceneChoice {
    bool default_light = true;        // for scenes without any
    std::string environment;          // an image file: the sky; empty: the scene's own
    float environment_intensity = 1;  // nits of 1 in that file
    std::string variant;              // of the file's KHR_materials_variants, the one to show
    bool allow_outside = false;       // let the file name buffers and images outside of its own folder
    std::optional<PlacedBox> box;     // that the scene gets, after its default light
};

// Where somebody looks from who is no camera of the file.
struct CameraPose {
    dvec3 at{0};       // metres
    double yaw = 0;    // degrees about +Y; 0 looks along -Z, 90 along -X
    double pitch = 0;  // degrees, -90 down to 90 up
    double fov = 60;   // degrees, of the picture's height; more than 0, less than 180
    bool operator==(const CameraPose&) const = default;
};

// "1.5,1.7,-3,90,-10" with a sixth number for the field of view where it is not 60, and back: text_of() reads
// again as the same bits. Throws InputError for another count or what is out of range.
CameraPose pose_of(const std::string& text);
std::string text_of(const CameraPose& pose);  // as pose_of() takes it
// The same as a node's transform and a camera: what every program that looks from a pose uses.
Transform transform_of(const CameraPose& pose);
Camera camera_of(const CameraPose& pose);  // from 0.05 m on, without end
// The pose of a camera that looks like that; roll and shear are left out.
CameraPose pose_of(const dmat4& world, const Camera& camera);
// Puts a camera there, behind all nodes, and returns what SceneChoice::camera calls it. After
// add_default_light(): a lent light stays where it is, whoever looks.
std::string add_pose_camera(SceneData& scene, const CameraPose& pose);

// A box as `render --box` takes it, "X,Y,Z,SIDE", and back, as for poses. Throws InputError for another
// count, what is no number and a side that is not more than 0.
PlacedBox box_of(const std::string& text);
std::string text_of(const PlacedBox& box);  // as box_of() takes it

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
