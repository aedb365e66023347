// Plays a scene's animation and lets its bodies fall, for the commands that render it: any moment can be
// asked for.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/animation/animator.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/transforms.h"
#include "tools/lanthorn/scene/scene_physics.h"

namespace lanthorn::tools {

class ScenePlayer {
  public:
    // Of the scenes that have been spawned into `world`, each with its own clips. `animation` is a clip's
    // name, its number, "none", or empty for the first clip if there is one; a scene without it stands still.
    // Throws InputError naming `source` and the clips there are if no scene has it.
    ScenePlayer(ecs::World& world, const std::string& animation, const std::string& source);

    // Brings the world to the clip's moment `seconds` after its start, looped: local transforms, morph
    // weights, bodies (ScenePhysics), world transforms, deformed meshes at their full detail. What it writes
    // is a function of `seconds` alone.
    void show(double seconds);

    // The same in two steps: all but the deformed meshes, and these, as finely as `hints` ask for (null: at
    // their full detail).
    void pose(double seconds);
    void deform(const DetailHints* hints);

  private:
    void animate(double seconds);

    ecs::World& world_;
    ScenePhysics physics_;
    std::vector<ecs::Entity> players_;  // that play
    Animator animator_;
    Transforms transforms_;
    Deformation deformation_;
};

}  // namespace lanthorn::tools
