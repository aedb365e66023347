#include "tools/lanthorn/common/plan_report.h"

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::tools {

gi::GiPlan first_plan(const SceneData& scene, const Settings& settings) {
    ecs::World world;
    spawn(world, scene);
    return gi::first_plan(still_scene(world), gi::gi_settings(settings));
}

}  // namespace lanthorn::tools
