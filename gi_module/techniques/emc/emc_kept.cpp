#include "gi_module/techniques/emc/emc_kept.h"

#include <algorithm>

#include "gi_module/techniques/emc/emc_plan.h"

namespace lanthorn::gi {

namespace {

using Pass = EmcPass;

// Frames with rays from one survey of what they met to the next.
constexpr int kSurveyInterval = 8;

void maps_done(EmcKept& kept, const EmcPlan& plan, const EmcResults& results, const Aabb& bounds) {
    if (plan.on(Pass::selection)) {
        kept.chosen_for = bounds;
        kept.update.reset();
        kept.lacks_maps = false;
    } else {
        if (kept.round.differs(EmcInput::round_settings, plan.now)) {
            kept.update.restart_round();
        }
        kept.update.advance(plan.round_due, results.exchanged, plan.update);
    }
    kept.centres.made(plan.now);
    kept.maps.made(plan.now);
    kept.round.made(plan.now);
    kept.fading = results.fading;
}

void lit_maps_done(EmcKept& kept, const EmcPlan& plan) {
    for (EmcStamps* part : {&kept.lit_texels, &kept.lit_colours, &kept.lit_light, &kept.lit_rays}) {
        part->made(plan.now);
    }
    if (plan.by_photons()) {
        kept.lit_photons.made(plan.now);
    } else {
        kept.lit_photons.forget();
    }
    const bool other_light = plan.lit.light || (plan.by_photons() && plan.light_frames == 0);
    kept.light_frames = other_light ? 1 : kept.light_frames + 1;
    kept.texel_frames = plan.texel_frames + (plan.lit.shoot ? 1 : 0);
}

void gather_done(EmcKept& kept, const EmcPlan& plan) {
    kept.point_rays.made(plan.now);
    kept.point_frames = plan.point_frames + (plan.gather.shoot ? 1 : 0);
    if (plan.gather.survey) {
        kept.survey_in = kSurveyInterval;
    } else if (plan.gather.shoot) {
        kept.survey_in = std::max(kept.survey_in - 1, 0);
    }
}

void caustics_done(EmcKept& kept, const EmcPlan& plan) {
    if (!plan.caustics) {
        kept.no_caustics();
        return;
    }
    if (plan.on(Pass::caustic_photons)) {
        kept.caustics.made(plan.now);
    }
    kept.caustic_surfaces.made(plan.now);
    kept.caustic_image.made(plan.now);
}

void specular_done(EmcKept& kept, const EmcPlan& plan) {
    if (plan.on(Pass::specular)) {
        kept.specular_rays.made(plan.now);
        kept.specular.made(plan.now);
    } else if (!plan.has_specular()) {
        kept.specular_rays.forget();
        kept.specular.forget();
    }
}

}  // namespace

void EmcKept::done(const EmcPlan& plan, const EmcResults& results, const Aabb& bounds) {
    maps_done(*this, plan, results, bounds);
    this->bounces = plan.bounces;
    lit_bounces = plan.lit_bounces;
    if (plan.on(Pass::emission)) {
        photons.made(plan.now);
    }
    if (plan.on(Pass::splats)) {
        splat_surroundings.made(plan.now);
    }
    if (plan.on(Pass::lit_maps)) {
        lit_maps_done(*this, plan);
    }
    if (plan.on(Pass::gather)) {
        gather_done(*this, plan);
    }
    if (plan.on(Pass::gather) || plan.on(Pass::splats) || plan.on(Pass::accumulation)) {
        passes = plan.pass + 1;
    }
    if (passes <= 1) {
        estimated_error.reset();
    }
    image.made(plan.now);
    materials.made(plan.now);
    caustics_done(*this, plan);
    specular_done(*this, plan);
}

void EmcKept::no_map() {
    centres.forget();
    no_caustics();
}

void EmcKept::no_caustics() {
    caustics.forget();
    caustic_surfaces.forget();
    caustic_image.forget();
}

}  // namespace lanthorn::gi
