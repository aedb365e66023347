// The scene in an App: transforms, motion between steps, and what the renderer is given of it.
#pragma once

#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// Add it first. Resources: Transforms, Extractor, SimulatedPose, FrameScene.
//
//   fixed:  restore -> restore.transforms -> gameplay.begin -> (gameplay) -> gameplay.end -> (animation) ->
//   transforms
//           -> (physics, settle) -> remember
//   frame:  interpolate -> (animation) -> transforms -> (deformation) -> extract.begin -> extract
//
// Systems of a game say `.in("gameplay")`, a group that may be empty; commands that they give are done at
// gameplay.end.
class ScenePlugin final : public Plugin {
  public:
    std::string_view name() const override { return "scene"; }
    void build(App& app) override;
};

}  // namespace lanthorn
