// Animation in an App.
#pragma once

#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// Needs ScenePlugin. `animation` moves every AnimationPlayer on by a step and poses its scene before physics,
// which what it moves may push; in the frame it poses them at the moment that is shown.
class AnimationPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "animation"; }
    void build(App& app) override;
};

}  // namespace lanthorn
