#include "gi_module/shared/mirrors/mirror_view.h"
#include "gi_module/shared/plan_rules.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "gi_module/techniques/emc/splat/glossy_splats.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

bool shows_specular(const FrameScene& scene, const GiSettings& settings) {
    return settings.specular_roughness > 0 &&
           (any_specular(scene, settings.specular_roughness) || !settings.of<PlanRules>().mirrors);
}

bool shows_glossy(const FrameScene& scene, const GiSettings& settings) {
    const auto& e = settings.of<EmcSettings>();
    return e.final_stage == EmcFinal::splat && e.splat_glossy != GlossyBandwidth::none &&
           any_specular(scene, kGlossyRoughness);
}

void plan_specular(EmcPlan& plan, const GiSettings& settings, const EmcFrame& frame, const EmcKept& kept) {
    using Pass = EmcPass;
    using Reason = EmcReason;
    if (!frame.specular) {
        plan.set(Pass::specular, false,
                 settings.specular_roughness > 0 ? Reason::lobes_are_wide : Reason::specular_is_off);
        return;
    }
    const bool rule = settings.of<PlanRules>().mirrors;
    plan.specular_rays = kept.specular_rays.due(plan.now) || !rule;
    const bool needed = kept.specular_rays.due(plan.now) || kept.specular.due(plan.now);
    plan.set(Pass::specular, needed || !rule,
             needed  ? Reason::mirrors_show_more
             : !rule ? Reason::rule_is_off
                     : Reason::image_holds);
}

}  // namespace lanthorn::gi
