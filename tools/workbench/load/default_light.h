// The light that a command adds to a scene: an environment image, or something for a scene that has
// none of its own.
#pragma once

#include <optional>
#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::workbench {

// Adds the sky of an image file, times `intensity`, and the suns in it as directional lights. What
// was mended becomes one of the scene's warnings. Throws InputError as read_sky().
void add_environment(SceneData& scene, const std::string& file, float intensity);

// Gives a scene with geometry whose lights are suns alone, and no sky, that of a clear day about the
// brightest of them, where it is above the horizon and the camera (SceneView's) is under the open sky: as
// much less bright than the day's as the sun is. And a scene with geometry but no light (punctual, emissive
// or sky) one of its own. Where surfaces shine, but would light the box around the scene with less than 0.1
// lx on average, and the camera is under the open sky, that is no light either: a filament in a lamp's globe.
// Where the camera (SceneView's) is under the open sky, a clear day's sky, and its sun over the camera's left
// shoulder. In a room, a point light there, nearer if a surface is in the way, with 1000 lx on what the
// camera looks at. Returns one line for the user if it did, else nothing. Throws InputError for a camera that
// is not there. Cheap for scenes with lights or a sky; for others a copy of the scene and Embree's
// structures.
std::optional<std::string> add_default_light(SceneData& scene, const std::string& camera);

}  // namespace lanthorn::workbench
