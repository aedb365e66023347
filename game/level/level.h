// A level in an App: the glTF scene's entities, with the components that their extras name.
#pragma once

#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

// Spawns the scene and gets it ready to be played: its first animation that is no figure's plays, the player
// sees with her eyes or, where there is a follow_camera, by that.
// Needs add_scene_plugins() and GamePlugin. Throws InputError, naming file and node, if there is not one
// player with {"player": {}} and {"character": {}} and, below her, one camera with {"eyes": {}}; if more than
// one node has {"level": {}}; if a lantern is below another node; if a crystal has no {"light_sensor": {}}
// beside it; if several lights are below a lantern or a crystal; if a figure or a hand names a clip that the
// file has not, or is below nothing that moves it; if a cloth has not a joint for each of its points; or if
// extras are not as the components are declared.
void load_level(App& app, const SceneData& scene);

}  // namespace lanthorn::game
