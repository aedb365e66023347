// The rules of lamplighter, the sample game, for programs that open its levels: to look at them, to play
// them, to edit them.
//
//   App app;
//   add_scene_plugins(app);
//   app.add<SensorPlugin>().add<game::GamePlugin>();
//   game::load_level(app, import_gltf("red-wall.glb"));
#pragma once

#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

// What a level's nodes can have in their extras (docs/levels.md), for a program in which nothing of it is
// played. GamePlugin has it too.
void declare_components(ecs::Registry& registry);

// Needs add_scene_plugins(). Declares the game's components; its systems run in the fixed steps, in the group
// "gameplay". Resources: PlayerInput (what came in for the step; written before the systems run), Intent.
//
//   fixed:  take_input -> swing_doors -> slide_shutters -> push_along -> turn_tables -> carry_lanterns
//           take_input -> walk
//           sensors.read -> reach_goals
//           sensors.read, carry_lanterns -> wake_crystals -> show_glow
class GamePlugin final : public Plugin {
  public:
    std::string_view name() const override { return "lamplighter"; }
    void build(App& app) override;
};

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
