// Rigid bodies and characters in an App.
#pragma once

#include "lanthorn/physics/physics.h"
#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// Needs ScenePlugin. Resource: std::shared_ptr<physics::Physics>. Steps after animation and transforms, so
// that what an animation moves pushes from where it is; `settle` brings world transforms up to date with
// where the bodies went. Dynamic bodies and characters become Interpolated. `physics.afresh` has Physics
// forget at key steps what is in no component.
class PhysicsPlugin final : public Plugin {
  public:
    // Its time_step is the App's. Throws InputError for a setting out of its range.
    explicit PhysicsPlugin(const physics::PhysicsSettings& settings = {});
    std::string_view name() const override { return "physics"; }
    void build(App& app) override;

  private:
    physics::PhysicsSettings settings_;
};

}  // namespace lanthorn
