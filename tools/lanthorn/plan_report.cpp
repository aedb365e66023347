#include "tools/lanthorn/plan_report.h"

#include "engine/deformation/deformation.h"
#include "engine/render/render_settings.h"
#include "engine/scene/extract.h"
#include "engine/scene/spawn.h"
#include "gi_module/gi_settings.h"
#include "gi_module/plan.h"
#include "gi_module/reference/path_settings.h"

namespace lanthorn::tools {

void declare_all_settings(SettingsSchema& schema) {
    render::declare_render_settings(schema);
    gi::declare_gi_settings(schema);
    reference::declare_path_settings(schema);
}

std::string plan_report(const SceneData& scene, const Settings& settings) {
    ecs::World world;
    spawn(world, scene);
    Deformation().update(world);
    const FrameScene frame = Extractor().extract(world);
    return gi::plan_table(gi::make_plan(frame, gi::gi_settings(settings), {}));
}

}  // namespace lanthorn::tools
