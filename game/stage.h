// The scene that is looked at: a world of its own whose door, lantern and camera follow the simulation's
// views.
#pragma once

#include "game/level.h"
#include "game/simulation.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::game {

class Stage {
  public:
    Stage(const SceneData& scene, const Level& level);

    // The scene as `view` has it, seen by the player. What changed counts from the call before.
    FrameScene show(const View& view);
    // The same, seen by the scene's camera of that name; throws InputError if there is none.
    FrameScene show(const View& view, const std::string& camera);

  private:
    void follow(const View& view);
    void place(ecs::Entity entity, const Transform& transform);

    ecs::World world_;
    Transforms transforms_;
    Extractor extractor_;
    Camera player_camera_;
    ecs::Entity door_, lantern_, lantern_light_;
    Transform door_at_rest_;
    Light light_;
};

}  // namespace lanthorn::game
