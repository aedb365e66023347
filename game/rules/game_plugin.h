// The game's rules in an App.
#pragma once

#include "lanthorn/runtime/plugin.h"

namespace lanthorn::game {

// Needs add_scene_plugins(). Declares the game's components; its systems run in the fixed steps, before
// gameplay.end. Resources: PlayerInput (what came in for the step; written before the systems run), Intent.
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

}  // namespace lanthorn::game
