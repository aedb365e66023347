#include "tools/lanthorn/common/plan_report.h"

#include "lanthorn/deformation/deformation.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/plan.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"

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
