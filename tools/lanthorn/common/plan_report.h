#pragma once

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/plan.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

// What the light of the scene's first frame requires with these settings. No GL.
gi::GiPlan first_plan(const SceneData& scene, const Settings& settings);

}  // namespace lanthorn::tools
