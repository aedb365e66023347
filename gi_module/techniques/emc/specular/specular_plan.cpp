#include "gi_module/shared/mirrors/mirror_view.h"
#include "gi_module/techniques/emc/emc_plan.h"

namespace lanthorn::gi {

void plan_specular(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings,
                   const EmcHistory& history) {
    using Pass = EmcPass;
    using Reason = EmcReason;
    if (settings.specular_roughness <= 0) {
        plan.set(Pass::specular, false, Reason::specular_is_off);
        return;
    }
    if (!any_specular(scene, settings.specular_roughness)) {
        plan.set(Pass::specular, false, Reason::lobes_are_wide);
        return;
    }
    const SceneChanges& changes = scene.changes;
    plan.specular_rays = !history.has_specular || !history.has_image || changes.camera || changes.relief ||
                         changes.assets || changes.geometry || changes.pattern || !changes.painted.empty() ||
                         plan.on(Pass::progressive_update);
    const bool light = plan.on(Pass::gather) || plan.on(Pass::splats) || plan.on(Pass::caustic_splats) ||
                       changes.lights || changes.emission || history.other_light_maps;
    const bool on = plan.specular_rays || light;
    plan.set(Pass::specular, on, on ? Reason::mirrors_show_more : Reason::image_holds);
}

}  // namespace lanthorn::gi
