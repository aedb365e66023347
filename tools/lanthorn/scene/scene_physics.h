// A scene's rigid bodies and characters at any moment, for the commands that show it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::tools {

// The components that a scene's extras may name where it is shown.
const ecs::Registry& shown_components();

class ScenePhysics {
  public:
    // Of the scene that has been spawned into `world`, before anything moved.
    explicit ScenePhysics(ecs::World& world);

    // Whether anything moves by physics: a dynamic body or a character.
    bool moves() const { return !movers_.empty(); }

    // Brings the bodies to the last fixed step (1/60 s) that is not after `seconds`, by all steps since the
    // one shown last; for an earlier moment from the start again. `animate(t)` writes the LocalTransforms
    // that something else moves at moment t, before each step; call it for `seconds` itself afterwards. What
    // comes out is a function of `seconds` alone, bit by bit. WorldTransforms are those of the last step.
    void run_to(double seconds, const std::function<void(double)>& animate);

  private:
    void start_again();

    ecs::World& world_;
    std::vector<std::pair<ecs::Entity, Transform>> movers_;  // and where they start
    Transforms transforms_;
    std::unique_ptr<physics::Physics> physics_;
    std::uint64_t steps_ = 0;
};

}  // namespace lanthorn::tools
