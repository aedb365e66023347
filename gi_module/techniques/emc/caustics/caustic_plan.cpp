#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/plan_rules.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = EmcPass;
using Reason = EmcReason;
using Input = EmcInput;

// Whether the picture has caustics; else why not.
bool has_caustics(const FrameScene& scene, const GiSettings& s, Reason& why) {
    const CausticCause cause = caustic_cause(scene);
    if (cause == CausticCause::nothing_specular) {
        why = Reason::no_specular;
    } else if (s.of<EmcSettings>().caustic_photons == 0) {
        why = Reason::no_caustics_wanted;
    } else if (cause == CausticCause::no_light) {
        why = Reason::specular_in_the_dark;
    } else {
        return true;
    }
    return false;
}

Reason why_photons(const EmcKept& kept, const EmcStamps::Versions& now) {
    if (kept.caustics.empty()) {
        return Reason::no_caustics_yet;
    }
    const auto other = kept.caustics.other(now);
    if (!other) {
        return Reason::caustics_hold;
    }
    switch (*other) {
        case Input::caustic_settings:
        case Input::origin:
        case Input::darkness:
            return Reason::no_caustics_yet;
        case Input::lights:
            return Reason::light_changed;
        case Input::emission:
            return Reason::emission_changed;
        default:
            return Reason::surfaces_changed;
    }
}

}  // namespace

void plan_caustics(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, bool exact_rays,
                   const EmcKept& kept) {
    plan.caustics_by_maps = s.of<EmcSettings>().rays == EmcRays::maps || !exact_rays;
    std::uint64_t& photons = version_of(plan.now, Input::caustic_photons);
    Reason none{};
    if (!has_caustics(scene, s, none)) {
        plan.set(Pass::caustic_photons, false, none);
        plan.set(Pass::caustic_splats, false, none);
        photons += kept.caustics.empty() ? 0 : 1;
        return;
    }
    plan.caustics = true;
    const auto other = kept.caustics.other(plan.now);
    const bool rule = s.of<PlanRules>().caustics;
    const bool trace = kept.caustics.due(plan.now) || !rule;
    plan.keep_caustics = other == Input::lights || other == Input::emission;
    plan.set(Pass::caustic_photons, trace,
             kept.caustics.due(plan.now) || rule ? why_photons(kept, plan.now) : Reason::rule_is_off);
    photons += trace ? 1 : 0;

    const auto picture = kept.caustic_image.other(plan.now);
    const bool final_stage = picture == Input::picture || picture == Input::mean_picture;
    const bool view = kept.caustic_image.empty() || (picture && !final_stage);
    plan.splat_caustics = view;
    plan.caustic_surfaces = kept.caustic_surfaces.due(plan.now);
    plan.set(Pass::caustic_splats, view || final_stage,
             trace                      ? Reason::new_photons
             : final_stage              ? Reason::final_stage_changed
             : picture == Input::camera ? Reason::camera_moved
             : view                     ? Reason::no_image_yet
                                        : Reason::image_holds);
}

}  // namespace lanthorn::gi
