// Light sensors in an App: how their readings enter the simulation.
#pragma once

#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// Needs ScenePlugin. Resource: SensorInbox. In a fixed step `sensors.read` writes what is in there into the
// LightSensors, each the last of its samples, and empties it. What fills it is gi::GiPlugin's `sensors` in
// the frame, or the replay of a session; without either, sensors read nothing.
//
//   fixed:  restore -> sensors.read -> (gameplay)
class SensorPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "sensors"; }
    void build(App& app) override;
};

}  // namespace lanthorn
