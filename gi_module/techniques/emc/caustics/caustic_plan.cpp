#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

void plan_caustics(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcHistory& history) {
    using Pass = EmcPass;
    using Reason = EmcReason;
    const auto none = [&](Reason why) {
        plan.set(Pass::caustic_photons, false, why);
        plan.set(Pass::caustic_splats, false, why);
    };
    const CausticCause cause = caustic_cause(scene);
    if (cause == CausticCause::nothing_specular) {
        return none(Reason::no_specular);
    }
    if (s.of<EmcSettings>().caustic_photons == 0) {
        return none(Reason::no_caustics_wanted);
    }
    if (s.of<EmcSettings>().rays == EmcRays::maps || !history.exact_rays) {
        return none(Reason::no_exact_rays);
    }
    if (cause == CausticCause::no_light) {
        return none(Reason::specular_in_the_dark);
    }
    plan.caustics = true;
    const SceneChanges& changes = scene.changes;
    const bool surfaces = changes.geometry || changes.assets || !changes.painted.empty() || changes.relief;
    const bool trace = !history.has_caustics || surfaces || changes.lights || changes.emission;
    plan.keep_caustics = trace && history.has_caustics && !surfaces;
    plan.set(Pass::caustic_photons, trace,
             !history.has_caustics ? Reason::no_caustics_yet
             : surfaces            ? Reason::surfaces_changed
             : changes.lights      ? Reason::light_changed
             : changes.emission    ? Reason::emission_changed
                                   : Reason::caustics_hold);
    const bool view = changes.camera || !history.has_caustic_image;
    plan.splat_caustics = trace || view;
    const bool final_stage = plan.on(Pass::gather) || plan.on(Pass::splats) || plan.on(Pass::accumulation);
    plan.set(Pass::caustic_splats, plan.splat_caustics || final_stage,
             trace                        ? Reason::new_photons
             : !history.has_caustic_image ? Reason::no_image_yet
             : changes.camera             ? Reason::camera_moved
             : final_stage                ? Reason::final_stage_changed
                                          : Reason::image_holds);
}

}  // namespace lanthorn::gi
